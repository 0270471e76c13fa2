// Text from strangers' files, character by character.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::view {

struct Utf8Char {
  char32_t code;  // U+FFFD for a byte that is no UTF-8
  size_t bytes;   // at least 1
};

// The character that starts at `at` (< text.size()).
Utf8Char nextChar(std::string_view text, size_t at);
void appendUtf8(std::string& text, char32_t code);

// Columns that a character takes on a terminal: 0, 1 or 2. Control characters count as one.
size_t columnsOf(char32_t code);
size_t columnCount(std::string_view text);

// `text` for a terminal: control characters, and those that turn the direction of writing, become
// spaces, and where `ascii` others beyond ASCII become '?'.
std::string tamed(std::string_view text, bool ascii);
// The same, at most `width` columns of it: a cut ends in an ellipsis ("..." where `ascii`).
std::string fitted(std::string_view text, size_t width, bool ascii);

}  // namespace obby::view
