// Properties of any bytes that are read as a stream of records. Errors have a text. Accepted
// records can be written in both encodings and read back to the same bytes.
#pragma once

#include <cstdlib>
#include <string>

#include "io/stream.h"

namespace obby::fuzz {

inline std::string written(schema::Record::Reader record, io::Format format) {
  std::string bytes;
  io::StreamWriter writer = io::StreamWriter::toBytes(format, &bytes);
  if (!writer.write(record)) __builtin_trap();
  return bytes;
}

// Checks that a record reads back to the same bytes. A header alone is not a stream, so reading it
// may fail.
inline void checkRewritten(const io::Record& record, io::Format format) {
  const std::string bytes = written(record.reader(), format);
  io::StreamReader reader = io::StreamReader::overBytes(bytes, "again");
  auto again = reader.next();
  if (!again && record.which() == io::Kind::HEADER) return;
  if (!again || !*again) __builtin_trap();
  if (written((*again)->reader(), format) != bytes) __builtin_trap();
}

inline void checkStream(std::string bytes) {
  io::StreamReader reader = io::StreamReader::overBytes(std::move(bytes), "fuzz");
  for (;;) {
    auto record = reader.next();
    if (!record) {
      if (record.error().message.empty()) __builtin_trap();
      if (!reader.canContinue()) return;
      continue;
    }
    if (!*record) return;
    if (!(*record)->known()) continue;
    checkRewritten(**record, io::Format::jsonl);
    checkRewritten(**record, io::Format::capnp);
    checkRewritten(**record, io::Format::capnpPacked);
  }
}

}  // namespace obby::fuzz
