// Names of the encodings.
#include "io/stream.h"
#include "io/text.h"

namespace obby::io {

Result<Format> parseFormat(const std::string& text) {
  if (text == "jsonl") return Format::jsonl;
  if (text == "capnp") return Format::capnp;
  if (text == "packed") return Format::capnpPacked;
  return makeError("expected one of jsonl, capnp, packed, found " + io::quoted(text));
}

Format formatForFile(const std::string& path) {
  if (path.ends_with(".capnp")) return Format::capnp;
  if (path.ends_with(".capnpp")) return Format::capnpPacked;
  return Format::jsonl;
}

}  // namespace obby::io
