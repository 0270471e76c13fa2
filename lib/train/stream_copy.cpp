#include "train/stream_copy.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace obby::train {

namespace {

bool isWanted(const io::Record& record) {
  if (!record.known()) return false;
  const io::Kind kind = record.which();
  return kind == io::Kind::LEVEL || kind == io::Kind::QUERY || kind == io::Kind::PARAMS;
}

}  // namespace

Result<StreamCopy> copyOfStream(io::SourceOptions options, Timeout& timeout, uint64_t max) {
  StreamCopy copy;
  io::RecordSource source(std::move(options));
  io::StreamWriter writer = io::StreamWriter::toBytes(io::Format::capnp, &copy.records);
  while (true) {
    OBBY_ASSIGN(const std::optional<io::Record> record, timeout.next(source));
    if (!record) break;
    if (isWanted(*record)) OBBY_RETURN_IF_ERROR(writer.write(record->reader()));
    if (copy.records.size() > max) {
      return makeError(fmt::format("the stream has more than {} bytes of levels, and several ranks "
                                   "must read all of it before they start",
                                   max),
                       "give fewer levels, use --generate, or train with one rank");
    }
  }
  OBBY_RETURN_IF_ERROR(writer.close());
  if (!timeout.stop()) OBBY_RETURN_IF_ERROR(source.checkWhole());
  copy.summary = source.summary();
  return copy;
}

}  // namespace obby::train
