// Parses the bytes of a place or model file into a Document. The content decides the format, never
// the file's name. A new format is one file in this folder and one row in read_document.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

// Returns true if the bytes begin like a Roblox file (binary or XML), not like a stream of records.
bool looksLikeRoblox(std::string_view bytes);

// Returns true if an input with this beginning may be a Roblox file. looksLikeRoblox() decides once
// the input is complete. Returns nullopt if more bytes are needed.
std::optional<bool> mayBeRoblox(std::string_view begin);

// Parses a document. `file` is used in errors and kept in the document. Errors name the byte offset
// and the chunk or element.
Result<Document> readDocument(std::string_view bytes, const std::string& file);

}  // namespace obby::importer
