// Random secrets and their comparison.
#include "loopback/secrets.h"

#include <gtest/gtest.h>

#include <set>

namespace obby::loopback {
namespace {

TEST(Secrets, random_digits_have_the_requested_length_and_differ) {
  std::set<std::string> seen;
  for (int i = 0; i < 100; i++) {
    const std::string digits = randomHex(32);
    EXPECT_EQ(digits.size(), 64u);
    EXPECT_EQ(digits.find_first_not_of("0123456789abcdef"), std::string::npos);
    seen.insert(digits);
  }
  EXPECT_EQ(seen.size(), 100u);
}

TEST(Secrets, comparison_sees_every_byte) {
  const std::string a = randomHex(32);
  EXPECT_TRUE(equalInConstantTime(a, a));
  for (size_t i = 0; i < a.size(); i++) {
    std::string b = a;
    b[i] = char(b[i] ^ 1);
    EXPECT_FALSE(equalInConstantTime(a, b)) << i;
  }
  EXPECT_FALSE(equalInConstantTime(a, a.substr(1)));
  EXPECT_TRUE(equalInConstantTime("", ""));
}

}  // namespace
}  // namespace obby::loopback
