#include "io/format.h"

#include "io/text.h"

namespace obby::io {

Result<Format> parseFormat(const std::string& text) {
  for (const Format format : {Format::jsonl, Format::capnp, Format::capnpPacked})
    if (text == nameOf(format)) return format;
  return makeError("expected jsonl, capnp or packed, found " + io::quoted(text));
}

const char* nameOf(Format format) {
  switch (format) {
    case Format::jsonl: return "jsonl";
    case Format::capnp: return "capnp";
    case Format::capnpPacked: break;
  }
  return "packed";
}

Format formatForFile(const std::string& path) {
  if (path.ends_with(".capnp")) return Format::capnp;
  if (path.ends_with(".capnpp")) return Format::capnpPacked;
  return Format::jsonl;
}

}  // namespace obby::io
