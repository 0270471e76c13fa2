// Errors print as one line, and a Result holds a value or an error.
#include "base/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace obby {
namespace {

TEST(ErrorText, NamesInputPlacePathMessageAndHint) {
  EXPECT_EQ(
      (Error{"level.jsonl", "12", "parts[88].size", "expected 3 numbers", "see --schema"}).text(),
      "level.jsonl:12: parts[88].size: expected 3 numbers (see --schema)");
}

TEST(ErrorText, OmitsMissingFields) {
  EXPECT_EQ((Error{"", "", "", "no", ""}).text(), "no");
  EXPECT_EQ((Error{"a", "", "", "no", ""}).text(), "a: no");
  EXPECT_EQ((Error{"", "byte 7", "", "no", ""}).text(), "byte 7: no");
  EXPECT_EQ((Error{"", "", "goal", "no", ""}).text(), "goal: no");
  EXPECT_EQ((Error{"a", "3", "", "no", ""}).text(), "a:3: no");
  EXPECT_EQ((Error{"", "3", "goal", "no", ""}).text(), "3: goal: no");
  EXPECT_EQ((Error{"a", "", "goal", "no", "try"}).text(), "a: goal: no (try)");
  EXPECT_EQ(makeError("no", "try").text(), "no (try)");
}

Result<int> half(int n) {
  if (n % 2 != 0) return makeError("odd");
  return n / 2;
}
Result<int> quarter(int n) {
  OBBY_ASSIGN(const int h, half(n));
  return half(h);
}
Status checkEven(int n) {
  OBBY_RETURN_IF_ERROR(half(n));
  return {};
}

TEST(Result, HoldsAValueOrAnError) {
  const Result<int> good = half(6), bad = half(3);
  ASSERT_TRUE(bool(good));
  EXPECT_EQ(*good, 3);
  ASSERT_FALSE(bool(bad));
  EXPECT_EQ(bad.error().message, "odd");
}

TEST(Result, ErrorsPassThroughTheMacros) {
  EXPECT_EQ(*quarter(12), 3);
  EXPECT_FALSE(quarter(6));
  EXPECT_FALSE(quarter(5));
  EXPECT_TRUE(bool(checkEven(2)));
  EXPECT_EQ(checkEven(1).error().message, "odd");
}

TEST(Result, CarriesTypesThatOnlyMove) {
  Result<std::unique_ptr<int>> r = std::make_unique<int>(5);
  ASSERT_TRUE(bool(r));
  const std::unique_ptr<int> value = *std::move(r);
  EXPECT_EQ(*value, 5);
}

TEST(Result, AnErrorIsNotAValueEvenForStrings) {
  const Result<std::string> text = std::string("fine");
  EXPECT_TRUE(bool(text));
  const Result<std::string> bad = makeError("fine");
  EXPECT_FALSE(bool(bad));
}

}  // namespace
}  // namespace obby
