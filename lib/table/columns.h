// Measures how wide texts are on a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace obby::table {

// Returns the columns that a character takes on a terminal: 0, 1 or 2. Control characters count as
// one.
size_t columnsOf(char32_t code);
size_t columnCount(std::string_view text);

// Returns at most `width` columns of io::tamed() `text`. A text that is cut ends in an ellipsis, or
// "..." with `ascii`.
std::string fitted(std::string_view text, size_t width, bool ascii);

}  // namespace obby::table
