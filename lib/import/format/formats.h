// Lists the file formats that the importer reads. A new format is one file in this folder and one
// row in formats.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

struct Format {
  std::string_view name;
  bool (*looksLike)(std::string_view bytes);  // tests the content; the first match reads the file
  Result<Document> (*read)(std::string_view bytes, const std::string& file);
};

std::span<const Format> formats();

}  // namespace obby::importer
