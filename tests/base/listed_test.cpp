#include "base/listed.h"

#include <gtest/gtest.h>

namespace obby {
namespace {

TEST(Listed, HasCommasAndOneWordBeforeTheLast) {
  EXPECT_EQ(listed({}, "or"), "");
  EXPECT_EQ(listed({"a"}, "or"), "a");
  EXPECT_EQ(listed({"a", "b"}, "and"), "a and b");
  EXPECT_EQ(listed({"a", "b", "c"}, "or"), "a, b or c");
}

}  // namespace
}  // namespace obby
