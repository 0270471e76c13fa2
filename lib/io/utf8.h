// Texts from strangers' files, character by character, and made harmless for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::io {

// Bytes of the well-formed UTF-8 character at the start of `text`, 1 to 4; 0 if there is none.
size_t utf8Length(std::string_view text);

// Well-formed UTF-8: no overlong forms, no surrogates, at most U+10FFFF.
bool isUtf8(std::string_view text);

struct Utf8Char {
  char32_t code;  // U+FFFD for a byte that is no UTF-8
  size_t bytes;   // at least 1
};

// The character that starts at `at` (< text.size()).
Utf8Char nextChar(std::string_view text, size_t at);
// `code`: at most U+10FFFF.
void appendUtf8(std::string& text, char32_t code);

// Moves what comes after it on a terminal, or turns it round, in place of being seen: a control
// character, or one of the direction of writing.
bool isControl(char32_t code);

// The beginning of `text` that ends with a whole character, `most` bytes or fewer.
std::string_view cutAtChar(std::string_view text, size_t most);

// `text` with U+FFFD for each byte that is no UTF-8.
std::string validUtf8(std::string_view text);

// `text` for a terminal, as UTF-8: `instead` stands for each control character and each that turns
// the direction of writing, U+FFFD for each byte that is no UTF-8. Where `ascii`, '?' stands for
// all else beyond ASCII.
std::string tamed(std::string_view text, bool ascii, char instead = ' ');

}  // namespace obby::io
