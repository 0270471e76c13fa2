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

// At most `width` characters for a terminal: control characters become spaces, a cut ends in an
// ellipsis ("..." where `ascii`), and where `ascii` other characters become '?'.
std::string fitted(std::string_view text, size_t width, bool ascii);
size_t charCount(std::string_view text);

}  // namespace obby::view
