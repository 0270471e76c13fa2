// Small text functions that both codecs and the command line use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/utf8.h"

namespace obby::io {

// The mark that some editors put before UTF-8 text. It is not part of the text.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
// Returns `text` without the byte order mark at its start, if it has one.
std::string_view withoutByteOrderMark(std::string_view text);

// Returns `text` without the white space at both ends.
std::string_view trimmed(std::string_view text);

// Returns the length in bytes of a character at the start of UTF-8 `text` that XML cannot hold, not
// even by its number: a control character other than tab and line ends, U+FFFE or U+FFFF. Returns 0
// if XML can hold it.
size_t notInXml(std::string_view text);

// Returns UTF-8 `text` for HTML and SVG, with markup as entities and control characters as spaces.
std::string escapeMarkup(std::string_view text);

// Returns `text` for an error line, as a JSON string cut after `limit` bytes. Characters of
// isControl() are escaped, and '?' replaces a byte that is not UTF-8.
std::string quoted(std::string_view text, size_t limit = 40);

// Returns a count of things: "1 part", "3 parts".
std::string plural(uint64_t n, std::string_view noun);

// Describes data that was found instead of text, for an error line: `bytes` quoted, or "binary
// data" if they are not UTF-8 (except for a character cut at the end) or have control characters.
std::string described(std::string_view bytes);

}  // namespace obby::io
