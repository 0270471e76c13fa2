// Bytes of a place or model file to a Document. The format is told by content, never by the file's
// name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

// True if the bytes begin like a Roblox file (binary or XML) rather than like a stream of records.
bool looksLikeRoblox(std::string_view bytes);

// Whether an input that begins so may be a Roblox file, of which looksLikeRoblox() tells when it is
// whole. Nothing: more of it must be seen.
std::optional<bool> mayBeRoblox(std::string_view begin);

// `file` is used in errors and kept in the document. Errors name the byte offset and the chunk or
// element.
Result<Document> readDocument(std::string_view bytes, const std::string& file);

}  // namespace obby::importer
