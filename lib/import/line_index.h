// The lines of a text by their numbers. Only the places of some are kept: a text of nothing but
// line breaks would else take many times its size.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obby::importer {

class LineIndex {
 public:
  LineIndex() = default;  // of no line
  // The text, of less than 4 GiB, must outlive the index.
  explicit LineIndex(std::string_view text);

  // Line `number`, counted from 1, without its line break; nothing where there is none. What
  // follows the last line break is a line.
  std::optional<std::string_view> line(size_t number) const;
  // Bytes that it takes beside the text.
  size_t memory() const { return starts_.capacity() * sizeof(uint32_t); }

 private:
  std::string_view text_;
  std::vector<uint32_t> starts_;  // of every kStride-th line, from the first on
};

// A line of code as evidence quotes it: without the blanks around it, at most 70 bytes.
std::string quoteOf(std::string_view line);

}  // namespace obby::importer
