#include "import/format/read_document.h"

#include "import/format/binary_format.h"
#include "import/format/xml_format.h"
#include "io/text.h"

namespace obby::importer {
namespace {

// A format that the importer reads. In the table, the first row whose test succeeds reads the file.
struct Format {
  bool (*looksLike)(std::string_view bytes);  // tests the content
  Result<Document> (*read)(std::string_view bytes, const std::string& file);
};

constexpr Format kFormats[] = {
    {looksLikeBinary, readBinary},  // .rbxl, .rbxm
    {looksLikeXml, readXml},        // .rbxlx, .rbxmx
};

constexpr size_t kMaxBlanks = size_t(64) << 10;  // blanks to skip before the input is read whole

}  // namespace

bool looksLikeRoblox(std::string_view bytes) {
  for (const Format& format : kFormats) {
    if (format.looksLike(bytes)) return true;
  }
  return false;
}

// Every format begins with `<`; XML may have blanks and a byte order mark before it.
std::optional<bool> mayBeRoblox(std::string_view begin) {
  if (begin.size() < io::kByteOrderMark.size() && io::kByteOrderMark.starts_with(begin)) return {};
  const std::string_view text = io::withoutByteOrderMark(begin);
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos) return text[first] == '<';
  if (text.size() < kMaxBlanks) return {};
  return true;
}

Result<Document> readDocument(std::string_view bytes, const std::string& file) {
  for (const Format& format : kFormats) {
    if (format.looksLike(bytes)) return format.read(bytes, file);
  }
  return Error{file,
               "byte 0",
               {},
               "the file is not a Roblox place or model",
               "expected the binary or XML format of a .rbxl, .rbxm, .rbxlx or .rbxmx file"};
}

}  // namespace obby::importer
