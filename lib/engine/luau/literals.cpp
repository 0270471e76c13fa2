// Reads numbers, escapes and long strings as Luau does.
#include "engine/luau/literals.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>

namespace obby::luau {
namespace {

// Returns the value of an integer. Too many digits become the largest 64-bit number, as in Luau.
std::optional<double> integerValue(std::string_view digits, int base) {
  uint64_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (digits.empty() || end != digits.data() + digits.size()) return {};
  return error == std::errc::result_out_of_range ? double(UINT64_MAX) : double(value);
}

void appendUtf8(std::string& out, uint32_t code) {
  if (code < 0x80) {
    out += char(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  constexpr int kLead[] = {0, 0xC0, 0xE0, 0xF0};
  out += char(uint32_t(kLead[more]) | (code >> (6 * more)));
  for (int i = more - 1; i >= 0; --i) out += char(0x80 | ((code >> (6 * i)) & 0x3F));
}

// Returns the number from at most `maxCount` digits of a base.
std::optional<uint32_t> digits(std::string_view source, size_t& at, size_t maxCount, int base) {
  size_t count = 0;
  uint32_t value = 0;
  for (; count < maxCount && at < source.size(); ++count, ++at) {
    const unsigned char c = static_cast<unsigned char>(source[at]);
    if (base == 10 ? !isDigit(char(c)) : !std::isxdigit(c)) break;
    value = value * uint32_t(base) + uint32_t(isDigit(char(c)) ? c - '0' : (c | 0x20) - 'a' + 10);
  }
  if (count == 0) return {};
  return value;
}

bool readCodePoint(std::string_view source, size_t& at, std::string& value) {
  if (at >= source.size() || source[at] != '{') return false;
  ++at;
  const auto code = digits(source, at, 8, 16);
  if (!code || *code > 0x10FFFF || at >= source.size() || source[at] != '}') return false;
  ++at;
  appendUtf8(value, *code);
  return true;
}

bool readByte(std::string_view source, size_t& at, std::string& value) {
  const auto code = digits(source, at, 3, 10);
  if (!code || *code > 255) return false;
  value += char(*code);
  return true;
}

bool readHexByte(std::string_view source, size_t& at, std::string& value) {
  const size_t begin = at;
  const auto code = digits(source, at, 2, 16);
  if (!code || at != begin + 2) return false;
  value += char(*code);
  return true;
}

}  // namespace

std::optional<double> numberValue(std::string_view text) {
  std::string plain(text);
  std::erase(plain, '_');
  if (plain.size() >= 2 && plain[0] == '0') {
    const std::string_view digits = std::string_view(plain).substr(2);
    if ((plain[1] | ' ') == 'x') return integerValue(digits, 16);
    if ((plain[1] | ' ') == 'b') return integerValue(digits, 2);
  }
  char* end = nullptr;
  const double value = std::strtod(plain.c_str(), &end);
  if (plain.empty() || *end != '\0') return {};
  return value;
}

bool readEscape(std::string_view source, size_t& at, std::string& value) {
  constexpr std::string_view kLetters = "abfnrtv", kValues = "\a\b\f\n\r\t\v";
  if (at >= source.size()) return false;
  const char c = source[at];
  if (isDigit(c)) return readByte(source, at, value);
  ++at;
  if (c == 'x') return readHexByte(source, at, value);
  if (c == 'u') return readCodePoint(source, at, value);
  if (c == 'z') {
    while (at < source.size() && std::isspace(static_cast<unsigned char>(source[at]))) ++at;
    return true;
  }
  if (c == '\r' && at < source.size() && source[at] == '\n') {
    value += source[at++];
    return true;
  }
  const size_t letter = kLetters.find(c);
  value += letter == std::string_view::npos ? c : kValues[letter];
  return true;
}

std::string longText(std::string_view inside) {
  if (inside.starts_with("\r\n"))
    inside.remove_prefix(2);
  else if (inside.starts_with('\n'))
    inside.remove_prefix(1);
  std::string text;
  text.reserve(inside.size());
  for (size_t i = 0; i < inside.size(); ++i)
    if (inside[i] != '\r' || inside.substr(i, 2) != "\r\n") text += inside[i];
  return text;
}

}  // namespace obby::luau
