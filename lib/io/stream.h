// Streams of records: files, pipes, "-". Readers sniff the encoding and check the framing (header
// first, end last, concatenation allowed); writers are checked down to close(), so that a full disk
// is never a silent success.
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

// Reads one stream after another from a file. A stream with a header must have its end, and every
// line of it a newline; a hand-written one without a header needs neither. Blank lines are skipped.
class StreamReader {
 public:
  // `path` "-" is standard input. The error names the file and the reason. Once `stop` is set, a
  // waiting next() ends the input without the checks of a proper end; see stopped().
  static Result<StreamReader> open(const std::string& path,
                                   const std::atomic<bool>* stop = nullptr);
  // Over bytes in memory; `name` is used in errors.
  static StreamReader overBytes(std::string bytes, std::string name);
  // Over an input of which nothing is consumed yet.
  static StreamReader over(ByteSource source);

  StreamReader(StreamReader&&) noexcept;
  StreamReader& operator=(StreamReader&&) noexcept;
  ~StreamReader();

  // The next record, headers and ends included; nothing at the proper end of the input. Errors name
  // the input and the line or byte.
  Result<std::optional<Record>> next();

  // After an error: it was about one record, and next() goes on behind it. Otherwise (broken
  // framing, another schema version, a failing disk) next() gives the same error again.
  bool canContinue() const;
  // After such an error: that record was a level, or may have been one for all it says of its kind.
  bool lostLevel() const;
  // After such an error: that record as it came, not known().
  Record unread() const;
  bool stopped() const;

  const std::string& name() const;
  Format format() const;  // after the first next()

 private:
  struct Impl;
  explicit StreamReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// A record made here with its bytes in `format`, so that StreamWriter::pass has nothing left to do:
// for records that are encoded by several threads and written by one. Errors as of write().
Result<Record> encoded(RecordBuilder builder, Format format);

// Writes one stream. Every record goes out in whole lines (or messages). A file is written under a
// temporary name and renamed by close(); destroying an unclosed writer removes it.
class StreamWriter {
 public:
  // `stop` is as in Sink::open.
  static Result<StreamWriter> open(const std::string& path, Format format,
                                   const std::atomic<bool>* stop = nullptr);
  // Into memory, for tests and for embedding; take the bytes after close().
  static StreamWriter toBytes(Format format, std::string* bytes);
  // Encodes nothing: each record of a known kind goes to `take`, whose errors write() and pass()
  // return.
  static StreamWriter toFunction(std::function<Status(schema::Record::Reader)> take);

  StreamWriter(StreamWriter&&) noexcept;
  StreamWriter& operator=(StreamWriter&&) noexcept;
  ~StreamWriter();

  // The same record gives the same bytes, however it was built: fields that say nothing are left
  // out. Error: also a number that is not finite or out of range, text that is not UTF-8; nothing
  // is written then.
  Status write(schema::Record::Reader record);
  // Unchanged where the encodings agree, converted otherwise. A record that is not known() can only
  // be passed between equal encodings.
  Status pass(const Record& record);
  Status flush();
  Status close();

  bool failed() const;  // the output itself: nothing more can be written
  Format format() const;
  uint64_t recordsWritten() const;

 private:
  struct Impl;
  explicit StreamWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace obby::io
