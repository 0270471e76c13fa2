// Reads the binary format of .rbxl and .rbxm files.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

bool looksLikeBinary(std::string_view bytes);

Result<Document> readBinary(std::string_view bytes, const std::string& file);

}  // namespace obby::importer
