// Finds the lines of a text by number. Only every kStride-th offset is stored: otherwise a text of
// line breaks alone would take many times its size.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obby::importer {

class LineIndex {
 public:
  LineIndex() = default;  // an empty index
  // The text must outlive the index and be smaller than 4 GiB.
  explicit LineIndex(std::string_view text);

  // Returns line `number`, counted from 1, without its line break, or nullopt past the end. Text
  // after the last line break is a line.
  std::optional<std::string_view> line(size_t number) const;
  // Returns the bytes used besides the text.
  size_t memory() const { return starts_.capacity() * sizeof(uint32_t); }

 private:
  std::string_view text_;
  std::vector<uint32_t> starts_;  // offsets of every kStride-th line, from the first on
};

// Returns a line of code as evidence quotes it: without surrounding blanks, at most 70 bytes.
std::string quoteOf(std::string_view line);

}  // namespace obby::importer
