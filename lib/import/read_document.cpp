// Finds the format by content and hands over.
#include "import/read_document.h"

#include "import/format/formats.h"

namespace obby::importer {

bool looksLikeRoblox(std::string_view bytes) {
  for (const Format& format : formats()) {
    if (format.looksLike(bytes)) return true;
  }
  return false;
}

Result<Document> readDocument(std::string_view bytes, const std::string& file) {
  for (const Format& format : formats()) {
    if (format.looksLike(bytes)) return format.read(bytes, file);
  }
  return Error{file,
               "byte 0",
               {},
               "not a Roblox place or model",
               "expected the binary or the XML format of .rbxl, .rbxm, .rbxlx or .rbxmx files"};
}

}  // namespace obby::importer
