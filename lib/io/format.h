// The encodings of a stream.
#pragma once

#include <string>

#include "base/result.h"

namespace obby::io {

enum class Format { jsonl, capnp, capnpPacked };

// "jsonl", "capnp", "packed". Error names the choices.
Result<Format> parseFormat(const std::string& text);
const char* nameOf(Format format);
// By the ending of an output file name: .capnp, .capnpp (packed), anything else jsonl.
Format formatForFile(const std::string& path);

}  // namespace obby::io
