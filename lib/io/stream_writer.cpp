// StreamWriter: encodes records into a Sink.
#include <fmt/format.h>

#include "io/json_codec.h"
#include "io/message_codec.h"
#include "io/record_storage.h"
#include "io/stream.h"

namespace obby::io {

namespace {

// Returns a line with its newline, or a message.
Result<std::string> bytesOf(schema::Record::Reader record, Format format) {
  if (format != Format::jsonl) return messageFromRecord(record, format == Format::capnpPacked);
  OBBY_ASSIGN(std::string line, recordToJson(record));
  line += '\n';
  return line;
}

}  // namespace

Result<Record> encoded(RecordBuilder builder, Format format) {
  auto storage = std::make_shared<Record::Storage>();
  OBBY_ASSIGN(storage->raw, bytesOf(builder.reader(), format));
  if (format == Format::jsonl) storage->raw.pop_back();
  storage->format = format;
  storage->decoded = std::move(builder);
  return Record(std::move(storage));
}

struct StreamWriter::Impl {
  Sink sink;
  Format format;
  std::function<Status(schema::Record::Reader)> take = {};  // replaces the sink
  uint64_t records = 0;

  Status hand(schema::Record::Reader record) {
    OBBY_RETURN_IF_ERROR(take(record));
    records++;
    return {};
  }
  Status send(std::string_view piece) {
    OBBY_RETURN_IF_ERROR(sink.write(piece));
    records++;
    return {};
  }
};

Result<StreamWriter> StreamWriter::open(const std::string& path, Format format,
                                        const std::atomic<bool>* stop) {
  OBBY_ASSIGN(Sink sink, Sink::open(path, Durable::no, stop));
  return StreamWriter(std::make_unique<Impl>(Impl{std::move(sink), format}));
}

StreamWriter StreamWriter::toBytes(Format format, std::string* bytes) {
  return StreamWriter(std::make_unique<Impl>(Impl{Sink::toBytes(bytes), format}));
}

StreamWriter StreamWriter::toFunction(std::function<Status(schema::Record::Reader)> take) {
  return StreamWriter(
      std::make_unique<Impl>(Impl{Sink::toBytes(nullptr), Format::jsonl, std::move(take)}));
}

StreamWriter::StreamWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
StreamWriter::StreamWriter(StreamWriter&&) noexcept = default;
StreamWriter& StreamWriter::operator=(StreamWriter&&) noexcept = default;
StreamWriter::~StreamWriter() = default;

Status StreamWriter::write(schema::Record::Reader record) {
  if (impl_->take) return impl_->hand(record);
  OBBY_ASSIGN(const std::string piece, bytesOf(record, impl_->format));
  return impl_->send(piece);
}

Status StreamWriter::pass(const Record& record) {
  if (impl_->take) return record.known() ? impl_->hand(record.reader()) : Status();
  const Record::Storage& storage = record.storage();
  if (storage.format == impl_->format && !storage.raw.empty()) {
    if (storage.format != Format::jsonl) return impl_->send(storage.raw);
    return impl_->send(storage.raw + '\n');
  }
  if (record.known()) return write(record.reader());
  return Error{storage.input,
               storage.place,
               {},
               storage.unreadable
                   ? "cannot convert this record: it could not be read"
                   : "cannot convert this record: this program does not know its type",
               fmt::format("write the output in the format of the input: --format {}",
                           nameOf(storage.format))};
}

Status StreamWriter::flush() { return impl_->sink.flush(); }
Status StreamWriter::close() { return impl_->sink.close(); }
bool StreamWriter::failed() const { return impl_->sink.failed(); }
Format StreamWriter::format() const { return impl_->format; }
uint64_t StreamWriter::recordsWritten() const { return impl_->records; }

}  // namespace obby::io
