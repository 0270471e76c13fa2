// Paths, parameters and numbers of a request's target.
#include "loopback/target.h"

#include <gtest/gtest.h>

namespace obby::loopback {
namespace {

TEST(Target, is_split_into_path_and_parameters) {
  const Target target = targetOf("/a/b?x=1&y&=2&x==");
  EXPECT_EQ(target.path, "/a/b");
  ASSERT_EQ(target.parameters.size(), 4u);
  EXPECT_EQ(target.parameters[0].name, "x");
  EXPECT_EQ(target.parameters[0].value, "1");
  EXPECT_EQ(target.parameters[1].name, "y");
  EXPECT_EQ(target.parameters[1].value, "");
  EXPECT_EQ(target.parameters[2].name, "");
  EXPECT_EQ(target.parameters[2].text, "=2");
  EXPECT_EQ(target.parameters[3].value, "=");
  EXPECT_TRUE(targetOf("").path.empty());
  EXPECT_TRUE(targetOf("/a?").parameters.empty());
  EXPECT_EQ(targetOf("/a?&x=1").parameters.size(), 2u);
}

TEST(Target, numbers_are_digits_up_to_a_bound) {
  EXPECT_EQ(wholeNumber("0", 9), 0u);
  EXPECT_EQ(wholeNumber("18446744073709551615", UINT64_MAX), UINT64_MAX);
  for (const char* text :
       {"", "-1", "+1", " 1", "1 ", "1e3", "0x1", "10", "18446744073709551616"}) {
    EXPECT_FALSE(wholeNumber(text, 9)) << text;
  }
}

}  // namespace
}  // namespace obby::loopback
