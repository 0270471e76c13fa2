#include "io/read_file.h"

#include "io/byte_source.h"

namespace obby::io {

Result<std::string> readFile(const std::string& path, const std::atomic<bool>* stop, uint64_t max) {
  OBBY_ASSIGN(ByteSource source, ByteSource::open(path, stop));
  return readRest(source, max);
}

Result<std::string> readRest(ByteSource& source, uint64_t max) {
  OBBY_ASSIGN(std::string bytes, source.rest(max));
  if (source.stopped()) return Error{source.name(), {}, {}, kInterrupted, {}};
  return bytes;
}

bool isInterrupted(const Error& error) { return error.message == kInterrupted; }

}  // namespace obby::io
