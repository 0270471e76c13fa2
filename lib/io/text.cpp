#include "io/text.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/json_writer.h"

namespace obby::io {

std::string_view withoutByteOrderMark(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
  return text.substr(0, text.find_last_not_of(kSpace) + 1);
}

size_t notInXml(std::string_view text) {
  if (text.starts_with("\xef\xbf\xbe") || text.starts_with("\xef\xbf\xbf")) return 3;
  if (text.empty() || uint8_t(text[0]) >= 32) return 0;
  return text[0] == '\t' || text[0] == '\n' || text[0] == '\r' ? 0 : 1;
}

std::string escapeMarkup(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (const size_t bytes = notInXml(text.substr(i)); bytes > 0) {
      out += ' ';
      i += bytes - 1;
      continue;
    }
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += uint8_t(c) < 32 ? ' ' : c;
    }
  }
  return out;
}

std::string quoted(std::string_view text, size_t limit) {
  std::string whole, out;
  size_t i = 0;
  while (i < text.size() && i < limit) {
    const size_t n = utf8Length(text.substr(i, 4));
    whole += n == 0 ? std::string("?") : std::string(text.substr(i, n));
    i += std::max<size_t>(n, 1);
  }
  if (i < text.size()) whole += "...";
  const std::string json = JsonWriter().value(whole).finish();
  // JSON does not escape control characters beyond ASCII.
  for (size_t at = 0; at < json.size();) {
    const Utf8Char c = nextChar(json, at);
    if (c.code >= 0x80 && isControl(c.code)) {
      out += fmt::format("\\u{:04x}", uint32_t(c.code));
    } else {
      out.append(json, at, c.bytes);
    }
    at += c.bytes;
  }
  return out;
}

std::string plural(uint64_t n, std::string_view noun) {
  return fmt::format("{} {}{}", n, noun, n == 1 ? "" : "s");
}

std::string described(std::string_view bytes) {
  constexpr size_t kLongest = 4;  // max bytes of a character
  for (size_t at = 0; at < bytes.size();) {
    const size_t n = utf8Length(bytes.substr(at, kLongest));
    if (n == 0 && at + kLongest > bytes.size() && at > 0) break;
    const Utf8Char c = nextChar(bytes, at);
    const bool blank = c.code == '\t' || c.code == '\r' || c.code == '\n';
    if (n == 0 || (isControl(c.code) && !blank)) return "binary data";
    at += n;
  }
  return quoted(bytes);
}

}  // namespace obby::io
