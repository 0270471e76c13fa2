// Reads untrusted text character by character, and makes it safe for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::io {

// Returns the length, 1 to 4 bytes, of the well-formed UTF-8 character at the start of `text`, or 0
// if it does not start with one.
size_t utf8Length(std::string_view text);

// Returns true for well-formed UTF-8: no overlong forms, no surrogates, at most U+10FFFF.
bool isUtf8(std::string_view text);

struct Utf8Char {
  char32_t code;  // U+FFFD for a byte that is not UTF-8
  size_t bytes;   // at least 1
};

// Returns the character that starts at `at` (< text.size()).
Utf8Char nextChar(std::string_view text, size_t at);
// Appends a character. `code` is at most U+10FFFF.
void appendUtf8(std::string& text, char32_t code);

// Returns true for a character that is not shown on a terminal but moves or reverses what follows:
// a control character, or one that changes the writing direction.
bool isControl(char32_t code);

// Returns the beginning of `text` that ends with a whole character, at most `max` bytes.
std::string_view cutAtChar(std::string_view text, size_t max);

// Returns `text` with U+FFFD for each byte that is not UTF-8.
std::string validUtf8(std::string_view text);

// Returns `text` as UTF-8 that is safe for a terminal. `instead` replaces each character of
// isControl(), and U+FFFD each byte that is not UTF-8. With `ascii`, '?' replaces all other
// characters beyond ASCII.
std::string tamed(std::string_view text, bool ascii, char instead = ' ');

}  // namespace obby::io
