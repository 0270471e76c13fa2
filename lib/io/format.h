// The encodings of a stream.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::io {

enum class Format { jsonl, capnp, capnpPacked };

// Parses "jsonl", "capnp" or "packed". An error names the choices.
Result<Format> parseFormat(const std::string& text);
const char* nameOf(Format format);
// Returns the format for an output file's extension: .capnp, .capnpp (packed), anything else jsonl.
Format formatForFile(const std::string& path);

}  // namespace obby::io
