#include "table/columns.h"

#include <algorithm>

#include "io/utf8.h"

namespace obby::table {

size_t columnCount(std::string_view text) {
  size_t count = 0;
  for (size_t at = 0; at < text.size();) {
    const io::Utf8Char c = io::nextChar(text, at);
    at += c.bytes;
    count += columnsOf(c.code);
  }
  return count;
}

std::string fitted(std::string_view text, size_t width, bool ascii) {
  std::string out = io::tamed(text, ascii);
  if (columnCount(out) <= width) return out;
  const std::string_view ellipsis = ascii ? "..." : "…";
  const size_t space = width - std::min(width, columnCount(ellipsis));
  size_t kept = 0;
  for (size_t used = 0;;) {
    const io::Utf8Char c = io::nextChar(out, kept);
    used += columnsOf(c.code);
    if (used > space) break;
    kept += c.bytes;
  }
  out.resize(kept);
  out += ellipsis;
  return out;
}

}  // namespace obby::table
