// Streams of records: files, pipes, "-". Readers detect the encoding and check the framing (header
// first, end last, concatenation allowed). Writers are checked up to close(), so that a full disk
// is never a silent success.
//
//   OBBY_ASSIGN(auto reader, io::StreamReader::open("levels/teaser.jsonl"));
//   for (;;) {
//     OBBY_ASSIGN(const std::optional<io::Record> record, reader.next());
//     if (!record) break;
//     if (record->known() && record->which() == io::Kind::LEVEL) ...
//   }
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "io/format.h"
#include "io/record.h"
#include "io/sink.h"

namespace obby::io {

class ByteSource;

// Reads one stream after another from a file. A stream with a header must have its end, and a
// newline after every line; a hand-written one without a header needs neither. Blank lines are
// skipped.
class StreamReader {
 public:
  // `path` "-" is standard input. An error names the file and the reason. Once `stop` is set, a
  // waiting next() ends the input without the checks of a proper end; see stopped().
  static Result<StreamReader> open(const std::string& path,
                                   const std::atomic<bool>* stop = nullptr);
  // Reads bytes in memory. `name` is used in errors.
  static StreamReader overBytes(std::string bytes, std::string name);
  // Reads an input of which nothing is consumed yet.
  static StreamReader over(ByteSource source);

  StreamReader(StreamReader&&) noexcept;
  StreamReader& operator=(StreamReader&&) noexcept;
  ~StreamReader();

  // Returns the next record, headers and ends included, or nothing at the proper end of the input.
  // Errors name the input and the line or byte.
  Result<std::optional<Record>> next();

  // Returns true if an error was about one record, so that next() continues after it. Otherwise
  // (broken framing, another schema version, a failing disk) next() returns the same error again.
  bool canContinue() const;
  // If canContinue(), returns true if the unreadable record was a level, or may have been one.
  bool lostLevel() const;
  // If canContinue(), returns the unreadable record as read. It is not known().
  Record unread() const;
  bool stopped() const;

  const std::string& name() const;
  Format format() const;  // after the first next()

 private:
  struct Impl;
  explicit StreamReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// Returns a record of this program together with its bytes in `format`, so that StreamWriter::pass
// need not encode it. Several threads can then encode records that one thread writes. Errors are
// those of write().
Result<Record> encoded(RecordBuilder builder, Format format);

// Writes one stream. Every record goes out in whole lines (or messages). A file is written under a
// temporary name and renamed by close(); destroying an unclosed writer removes it.
class StreamWriter {
 public:
  // Sink::open explains `stop`.
  static Result<StreamWriter> open(const std::string& path, Format format,
                                   const std::atomic<bool>* stop = nullptr);
  // Writes to memory, for tests and for embedding. Take the bytes after close().
  static StreamWriter toBytes(Format format, std::string* bytes);
  // Encodes nothing. `take` receives each record of a known kind, and write() and pass() return its
  // errors.
  static StreamWriter toFunction(std::function<Status(schema::Record::Reader)> take);

  StreamWriter(StreamWriter&&) noexcept;
  StreamWriter& operator=(StreamWriter&&) noexcept;
  ~StreamWriter();

  // Writes a record. Equal records have equal bytes, however they were built: fields that are not
  // set are left out. A number that is not finite or out of range, and text that is not UTF-8, are
  // errors; nothing is written then.
  Status write(schema::Record::Reader record);
  // Passes a record on, unchanged if the encodings agree, otherwise converted. A record that is not
  // known() can only be passed between equal encodings.
  Status pass(const Record& record);
  Status flush();
  Status close();

  bool failed() const;  // the output itself failed, so nothing more can be written
  Format format() const;
  uint64_t recordsWritten() const;

 private:
  struct Impl;
  explicit StreamWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace obby::io
