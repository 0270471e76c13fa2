#include "import/document/line_index.h"

namespace obby::importer {
namespace {

constexpr size_t kStride = 16;  // lines per stored offset

}  // namespace

LineIndex::LineIndex(std::string_view text) : text_(text), starts_(1, 0) {
  size_t breaks = 0;
  for (size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    if (++breaks % kStride == 0) starts_.push_back(uint32_t(at + 1));
  starts_.shrink_to_fit();
}

std::optional<std::string_view> LineIndex::line(size_t number) const {
  if (number == 0 || (number - 1) / kStride >= starts_.size()) return std::nullopt;
  size_t begin = starts_[(number - 1) / kStride];
  for (size_t left = (number - 1) % kStride; left > 0; --left) {
    const size_t end = text_.find('\n', begin);
    if (end == std::string_view::npos) return std::nullopt;
    begin = end + 1;
  }
  return text_.substr(begin, text_.find('\n', begin) - begin);
}

std::string quoteOf(std::string_view line) {
  constexpr size_t kLongest = 70;
  constexpr const char* kBlanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  line = line.substr(0, line.find_last_not_of(kBlanks) + 1);
  std::string code;
  for (size_t i = 0; i < line.size() && code.size() <= kLongest; ++i)
    if (line[i] != '\r') code += line[i];
  if (code.size() > kLongest) code.replace(kLongest - 3, std::string::npos, "...");
  return code;
}

}  // namespace obby::importer
