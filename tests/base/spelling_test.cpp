// Tests the suggestions for mistyped names.
#include "base/spelling.h"

#include <gtest/gtest.h>

namespace obby {
namespace {

TEST(NearestName, IsTheFirstOfEquallyNearNames) {
  EXPECT_EQ(nearestName("Lavva", {"Base", "Lava", "Larva"}), "Lava");
  EXPECT_EQ(nearestName("Lava", {"Base", "Goal"}), "");
  EXPECT_EQ(nearestName("abcdef", {"abcdefgh", "abcdxf", "abc"}), "abcdxf");
  EXPECT_EQ(nearestName("abcdef", {"abcdefghi", "abc"}), "") << "half of it is too far";
  EXPECT_EQ(nearestName("levle", {"header", "level"}), "level") << "swapped letters are one slip";
  EXPECT_EQ(nearestName("evlel", {"level"}), "") << "of five letters two slips are too many";
  EXPECT_EQ(nearestName("", {}), "");
  EXPECT_EQ(nearestName(std::string(200, 'a'), {std::string(200, 'a')}), "") << "no slip";
}

TEST(Lower, LeavesAllButLettersOfAscii) { EXPECT_EQ(lower("AbZ_9\xc3\x84"), "abz_9\xc3\x84"); }

}  // namespace
}  // namespace obby
