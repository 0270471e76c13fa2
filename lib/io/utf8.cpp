// Splits text into characters as utf8Length() does. Each byte that begins no well-formed character
// counts as one broken byte.
#include "io/utf8.h"

namespace obby::io {

size_t utf8Length(std::string_view s) {
  const auto byte = [&](size_t i) { return i < s.size() ? uint8_t(s[i]) : uint8_t(0); };
  const auto tail = [&](size_t i, uint8_t lo = 0x80, uint8_t hi = 0xbf) {
    return byte(i) >= lo && byte(i) <= hi;
  };
  const uint8_t b = byte(0);
  if (b < 0x80) return 1;
  if (b >= 0xc2 && b <= 0xdf) return tail(1) ? 2 : 0;
  if (b >= 0xe0 && b <= 0xef) {
    const uint8_t lo = b == 0xe0 ? 0xa0 : 0x80, hi = b == 0xed ? 0x9f : 0xbf;
    return tail(1, lo, hi) && tail(2) ? 3 : 0;
  }
  if (b >= 0xf0 && b <= 0xf4) {
    const uint8_t lo = b == 0xf0 ? 0x90 : 0x80, hi = b == 0xf4 ? 0x8f : 0xbf;
    return tail(1, lo, hi) && tail(2) && tail(3) ? 4 : 0;
  }
  return 0;
}

bool isUtf8(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    const size_t n = utf8Length(text.substr(i, 4));
    if (n == 0) return false;
    i += n;
  }
  return true;
}

Utf8Char nextChar(std::string_view text, size_t at) {
  const size_t bytes = utf8Length(text.substr(at, 4));
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

bool isControl(char32_t code) {
  return code < 32 || (code >= 127 && code < 160) || code == 0x061c || code == 0x200e ||
         code == 0x200f || (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

std::string_view cutAtChar(std::string_view text, size_t max) {
  if (text.size() <= max) return text;
  size_t kept = 0;
  for (;;) {
    const size_t bytes = nextChar(text, kept).bytes;
    if (kept + bytes > max) return text.substr(0, kept);
    kept += bytes;
  }
}

std::string validUtf8(std::string_view text) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const Utf8Char c = nextChar(text, at);
    at += c.bytes;
    appendUtf8(out, c.code);
  }
  return out;
}

std::string tamed(std::string_view text, bool ascii, char instead) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const Utf8Char c = nextChar(text, at);
    at += c.bytes;
    if (isControl(c.code)) {
      out += instead;
    } else if (ascii && c.code >= 128) {
      out += '?';
    } else {
      appendUtf8(out, c.code);
    }
  }
  return out;
}

}  // namespace obby::io
