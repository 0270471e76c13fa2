// Numbers in JSON are the shortest that read back to the same bits.
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "io/json_codec.h"

namespace obby::io {
namespace {

float throughJson(float value) {
  RecordBuilder record;
  record.root().initQuery().setTimeLimit(value);
  auto line = recordToJson(record.reader());
  EXPECT_TRUE(line);
  auto back = recordFromJson(*line);
  EXPECT_TRUE(back) << *line;
  return back->reader().getQuery().getTimeLimit();
}

double throughJson(double value) {
  RecordBuilder record;
  record.root().initMetrics().initValues(1)[0].setValue(value);
  auto line = recordToJson(record.reader());
  EXPECT_TRUE(line);
  auto back = recordFromJson(*line);
  EXPECT_TRUE(back) << *line;
  return back->reader().getMetrics().getValues()[0].getValue();
}

TEST(Numbers, EverySortOfFloatSurvives) {
  Random random(1, 2);
  for (int i = 0; i < 30000; i++) {
    const float value = std::bit_cast<float>(random.next());
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::bit_cast<uint32_t>(throughJson(value)), std::bit_cast<uint32_t>(value));
  }
  using Limits = std::numeric_limits<float>;
  for (float value : {0.0f, -0.0f, 1.0f, 0.1f, Limits::max(), Limits::lowest(), Limits::min(),
                      Limits::denorm_min(), -Limits::denorm_min(), 16777216.0f, 1e10f, 1e-10f})
    EXPECT_EQ(std::bit_cast<uint32_t>(throughJson(value)), std::bit_cast<uint32_t>(value));
}

TEST(Numbers, EverySortOfDoubleSurvives) {
  Random random(3, 4);
  for (int i = 0; i < 30000; i++) {
    const uint64_t bits = uint64_t(random.next()) << 32 | random.next();
    const double value = std::bit_cast<double>(bits);
    if (!std::isfinite(value)) continue;
    EXPECT_EQ(std::bit_cast<uint64_t>(throughJson(value)), bits);
  }
  using Limits = std::numeric_limits<double>;
  for (double value : {-0.0, 0.1, 1e22, 1e23, Limits::max(), Limits::denorm_min(), 0x1p53, 1e300})
    EXPECT_EQ(std::bit_cast<uint64_t>(throughJson(value)), std::bit_cast<uint64_t>(value));
}

TEST(Numbers, AreAsShortAsTheyCanBe) {
  Random random(5, 6);
  for (int i = 0; i < 20000; i++) {
    const float value = std::bit_cast<float>(random.next());
    if (!std::isfinite(value) || value == 0) continue;
    RecordBuilder record;
    record.root().initQuery().setTimeLimit(value);
    const std::string line = *recordToJson(record.reader());
    char shortest[64];
    const auto end = std::to_chars(shortest, shortest + 64, value, std::chars_format::scientific);
    std::string digits, best;
    for (char c : line.substr(line.rfind(':')))
      if (c == 'e')
        break;
      else if (std::isdigit(c))
        digits += c;
    for (const char* c = shortest; c != end.ptr && *c != 'e'; c++)
      if (std::isdigit(*c)) best += *c;
    const auto trim = [](std::string s) {
      s.erase(0, std::min(s.find_first_not_of('0'), s.size()));
      while (!s.empty() && s.back() == '0') s.pop_back();
      return s;
    };
    EXPECT_EQ(trim(digits), trim(best)) << line;
  }
}

TEST(Numbers, AreRoundedOnceToTheNearestFloat) {
  // The number is halfway between two floats, plus an amount that is lost in a double. Rounding to
  // a double first would give a tie, which rounds to the even neighbour below.
  auto record = recordFromJson(R"({"type":"query","timeLimit":1.00000005960464477540})");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->reader().getQuery().getTimeLimit(), std::nextafterf(1.0f, 2.0f));
}

}  // namespace
}  // namespace obby::io
