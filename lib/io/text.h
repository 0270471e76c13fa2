// Small text work that both codecs and the command line need.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/utf8.h"

namespace obby::io {

// What some editors put before a text in UTF-8, of which it is no part.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
// `text` without the byte order mark at its start, if it has one.
std::string_view withoutByteOrderMark(std::string_view text);

// Bytes of what stands at the start of UTF-8 `text` and no XML can hold, not even by its number: a
// control character other than tab and the ends of lines, U+FFFE, U+FFFF. 0: XML can hold it.
size_t notInXml(std::string_view text);

// UTF-8 `text` for HTML and SVG: markup as entities, control characters as spaces.
std::string escapeMarkup(std::string_view text);

// Appends `text` as a JSON string with its quotes. `text` must be UTF-8.
void appendJsonString(std::string& out, std::string_view text);

// `text` for an error line, as a JSON string cut after `limit` bytes: characters of isControl()
// escaped, '?' for a byte that is no UTF-8.
std::string quoted(std::string_view text, size_t limit = 40);

// Describes what was found instead of text, for an error line: `bytes` quoted, or "binary data" if
// they are not UTF-8 (apart from a character cut at the end) or have control characters.
std::string described(std::string_view bytes);

}  // namespace obby::io
