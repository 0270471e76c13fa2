// Bytes of a place or model file to a Document. The format is told by content, never by the file's
// name.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "import/document.h"

namespace obby::importer {

// True if the bytes begin like a Roblox file (binary or XML) rather than like a stream of records.
bool looksLikeRoblox(std::string_view bytes);

// `file` is used in errors and kept in the document. Errors name the byte offset and the chunk or
// element.
Result<Document> readDocument(std::string_view bytes, const std::string& file);

}  // namespace obby::importer
