#include "io/json_writer.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <iterator>

#include "base/check.h"
#include "io/base64.h"
#include "io/utf8.h"

namespace obby::io {
namespace {

static_assert(std::endian::native == std::endian::little, "packed numbers are little-endian");

// The bytes that a JSON string can hold unchanged.
constexpr std::array<bool, 256> kPlain = [] {
  std::array<bool, 256> out{};
  for (size_t c = 0x20; c < 0x7f; ++c) out[c] = c != '"' && c != '\\';
  return out;
}();

void appendEscaped(std::string& out, char32_t code) {
  switch (code) {
    case '"': out += "\\\""; break;
    case '\\': out += "\\\\"; break;
    case '\n': out += "\\n"; break;
    case '\r': out += "\\r"; break;
    case '\t': out += "\\t"; break;
    default:
      if (code < 0x20 || code == 0x7f) {
        fmt::format_to(std::back_inserter(out), "\\u{:04x}", uint32_t(code));
      } else {
        appendUtf8(out, code);
      }
  }
}

}  // namespace

JsonWriter& JsonWriter::open(char bracket) {
  separate();
  text_ += bracket;
  closers_ += bracket == '{' ? '}' : ']';
  comma_ = false;
  return *this;
}

JsonWriter& JsonWriter::close() {
  OBBY_CHECK_LT(0u, closers_.size());
  text_ += closers_.back();
  closers_.pop_back();
  comma_ = true;
  return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  value(name);
  text_ += ':';
  comma_ = false;
  return *this;
}

JsonWriter& JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  separate();
  text_ += '"';
  for (size_t at = 0; at < text.size();) {
    size_t end = at;
    while (end < text.size() && kPlain[uint8_t(text[end])]) ++end;
    text_.append(text, at, end - at);
    if (end == text.size()) break;
    const Utf8Char c = nextChar(text, end);
    appendEscaped(text_, c.code);
    at = end + c.bytes;
  }
  text_ += '"';
  return *this;
}

JsonWriter& JsonWriter::value(double number) {
  if (!std::isfinite(number)) return null();
  if (number == 0 && std::signbit(number))
    return raw("-0.0");  // "-0" would read back as the whole number 0
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
  return *this;
}

JsonWriter& JsonWriter::value(float number) {
  if (!std::isfinite(number) || number == 0) return value(double(number));
  separate();
  fmt::format_to(std::back_inserter(text_), "{}", number);
  return *this;
}

JsonWriter& JsonWriter::base64(std::span<const uint8_t> bytes) {
  return raw('"' + encodeBase64({reinterpret_cast<const char*>(bytes.data()), bytes.size()}) + '"');
}

std::string JsonWriter::finish() {
  while (!closers_.empty()) close();
  comma_ = false;
  return std::move(text_);
}

}  // namespace obby::io
