// Reads the XML format of .rbxlx and .rbxmx files, and of .rbxl and .rbxm files before 2013.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

bool looksLikeXml(std::string_view bytes);

Result<Document> readXml(std::string_view bytes, const std::string& file);

}  // namespace obby::importer
