#include "engine/luau/number_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace obby::luau {
namespace {

// Returns digits with the decimal point after the first `point` of them.
std::string fixedText(std::string digits, int point) {
  const int count = int(digits.size());
  if (point <= 0) return "0." + std::string(size_t(-point), '0') + digits;
  if (count <= point) return digits + std::string(size_t(point - count), '0');
  return digits.insert(size_t(point), 1, '.');
}

}  // namespace

std::string numberText(double value) {
  if (std::isnan(value)) return "nan";
  const std::string sign = std::signbit(value) ? "-" : "";
  if (std::isinf(value)) return sign + "inf";
  char buffer[32];
  const auto result =
      std::to_chars(buffer, buffer + sizeof buffer, std::abs(value), std::chars_format::scientific);
  const std::string_view text(buffer, size_t(result.ptr - buffer));  // d.ddde+xx
  const size_t mark = text.find('e');
  std::string digits(text.substr(0, mark));
  std::erase(digits, '.');
  int exponent = 0;
  const char* const from = buffer + mark + (text[mark + 1] == '+' ? 2 : 1);
  std::from_chars(from, result.ptr, exponent);
  constexpr int kMinPoint = -5, kMaxPoint = 21;
  if (exponent + 1 >= kMinPoint && exponent + 1 <= kMaxPoint)
    return sign + fixedText(std::move(digits), exponent + 1);
  return sign + std::string(text);
}

}  // namespace obby::luau
