// Names of parts in messages.
#include "solve/report/part_text.h"

#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "support/tower.h"

namespace obby::solve {
namespace {

TEST(PartText, IsTheShortestUniqueName) {
  const io::RecordBuilder tower = support::tower();
  const auto level = tower.reader().getLevel();
  EXPECT_EQ(partText(level, 0), "'Base'");
  EXPECT_EQ(partText(level, 1), "'S1/Lava'");
  EXPECT_EQ(partText(level, 2), "'S2/Lava'");
}

TEST(PartText, AddsTheNumberIfNamesAreAmbiguous) {
  const auto record = io::recordFromJson(
      R"({"type":"level","name":"twins","parts":[{"name":"A"},{"name":"A"},{}]})");
  ASSERT_TRUE(record);
  const auto level = record->reader().getLevel();
  EXPECT_EQ(partText(level, 1), "'A' (part 1)");
  EXPECT_EQ(partText(level, 2), "part 2");
  EXPECT_EQ(partText(level, 9), "part 9") << "no such part";
}

}  // namespace
}  // namespace obby::solve
