// Characters as io/text tells them apart: every malformed form counts as one broken byte.
#include "view/utf8.h"

#include <algorithm>

#include "io/text.h"

namespace obby::view {

Utf8Char nextChar(std::string_view text, size_t at) {
  const size_t bytes = io::utf8Length(text.substr(at, 4));
  if (bytes == 0) return {0xfffd, 1};
  const auto byte = [&](size_t k) { return static_cast<unsigned char>(text[at + k]); };
  if (bytes == 1) return {byte(0), 1};
  char32_t code = byte(0) & (0x7fu >> bytes);
  for (size_t k = 1; k < bytes; ++k) code = code << 6 | (byte(k) & 0x3fu);
  return {code, bytes};
}

void appendUtf8(std::string& text, char32_t code) {
  const auto put = [&](char32_t value) { text += static_cast<char>(value); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | code >> 6);
    put(0x80 | (code & 63));
  } else if (code < 0x10000) {
    put(0xe0 | code >> 12);
    put(0x80 | (code >> 6 & 63));
    put(0x80 | (code & 63));
  } else {
    put(0xf0 | code >> 18);
    put(0x80 | (code >> 12 & 63));
    put(0x80 | (code >> 6 & 63));
    put(0x80 | (code & 63));
  }
}

size_t charCount(std::string_view text) {
  size_t count = 0;
  for (size_t at = 0; at < text.size(); at += nextChar(text, at).bytes) ++count;
  return count;
}

std::string fitted(std::string_view text, size_t width, bool ascii) {
  const std::string_view ellipsis = ascii ? "..." : "…";
  const size_t room =
      charCount(text) <= width ? width : width - std::min(width, charCount(ellipsis));
  std::string out;
  size_t used = 0;
  for (size_t at = 0; at < text.size() && used < room; ++used) {
    const Utf8Char c = nextChar(text, at);
    at += c.bytes;
    if (c.code < 32 || (c.code >= 127 && c.code < 160)) {
      out += ' ';
    } else if (ascii && c.code >= 128) {
      out += '?';
    } else {
      appendUtf8(out, c.code);
    }
  }
  if (room < width) out += ellipsis;
  return out;
}

}  // namespace obby::view
