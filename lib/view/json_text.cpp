// Escaping, numbers and base64 for the page's data.
#include "view/json_text.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "base/check.h"
#include "io/base64.h"
#include "io/utf8.h"

namespace obby::view {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian arrays");

void JsonText::separate() {
  if (comma_) text_ += ',';
  comma_ = true;
}

JsonText& JsonText::raw(std::string_view text) {
  separate();
  text_ += text;
  return *this;
}

JsonText& JsonText::open(char bracket) {
  separate();
  text_ += bracket;
  closers_.push_back(bracket == '{' ? '}' : ']');
  comma_ = false;
  return *this;
}

JsonText& JsonText::close() {
  OBBY_CHECK_LT(0u, closers_.size());
  text_ += closers_.back();
  closers_.pop_back();
  comma_ = true;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  value(name);
  text_ += ':';
  comma_ = false;
  return *this;
}

JsonText& JsonText::value(std::string_view text) {
  separate();
  text_ += '"';
  for (size_t at = 0; at < text.size();) {
    const io::Utf8Char c = io::nextChar(text, at);
    at += c.bytes;
    switch (c.code) {
      case '"': text_ += "\\\""; break;
      case '\\': text_ += "\\\\"; break;
      case '\n': text_ += "\\n"; break;
      case '\t': text_ += "\\t"; break;
      default:
        if (c.code < 32 || c.code == 127 || c.code == '<' || c.code == 0x2028 || c.code == 0x2029) {
          text_ += fmt::format("\\u{:04x}", uint32_t(c.code));
        } else {
          io::appendUtf8(text_, c.code);
        }
    }
  }
  text_ += '"';
  return *this;
}

JsonText& JsonText::value(bool flag) { return raw(flag ? "true" : "false"); }

JsonText& JsonText::value(double number) {
  return std::isfinite(number) ? raw(fmt::format("{}", number)) : null();
}

JsonText& JsonText::value(float number) {
  return std::isfinite(number) ? raw(fmt::format("{}", number)) : null();
}

JsonText& JsonText::base64(std::string_view bytes) {
  return raw('"' + io::encodeBase64(bytes) + '"');
}

}  // namespace obby::view
