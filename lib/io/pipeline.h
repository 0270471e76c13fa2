// The filter that every tool is: records of several inputs in order, framing taken off and put on
// again, what the tool does not act on passed through unchanged.
//
//   io::Pipeline pipeline(context.sourceOptions(), context.identity(), std::move(output));
//   return pipeline.runAndFinish([&](const io::Record& record) -> Result<io::Then> {
//     if (record.which() != io::Kind::QUERY) return io::Then::pass;
//     ... pipeline.write(answer.reader()) ...
//     return io::Then::pass;  // the query itself goes out behind its answers; io::Then::drop: not
//   });
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "io/record.h"
#include "io/stream.h"

namespace obby::io {

// What to do about a record that cannot be read or acted on. A broken framing (a truncated stream,
// another schema version) and a failing output always stop.
enum class OnError {
  stop,  // report it and end
  skip,  // report it, leave the record out, go on
  emit,  // report it, pass the record on as it came, go on
};

struct SourceOptions {
  std::vector<std::string> inputs = {"-"};
  OnError onError = OnError::stop;
  const std::atomic<bool>* stop = nullptr;        // set from outside: end the input early
  std::function<void(const Error&)> report = {};  // errors that did not stop the run
  // Fields and kinds that look misspelt, the first few of a run.
  std::function<void(const Error&)> warn = {};
  // How an input becomes a stream of records; absent: StreamReader::open. A tool that reads other
  // files than streams turns them into one here.
  std::function<Result<StreamReader>(const std::string& path)> open = {};
};

// What an end record says of the records before it.
struct SourceSummary {
  schema::EndStatus status = schema::EndStatus::COMPLETE;
  uint64_t skipped = 0, errors = 0;

  // Together with what came before, or from elsewhere: the graver status.
  void add(const SourceSummary& other);
};

// The records of several inputs, one after another, without headers and ends.
class RecordSource {
 public:
  explicit RecordSource(SourceOptions options);
  RecordSource(RecordSource&&) noexcept;
  ~RecordSource();

  // The next record; nothing at the end of the last input, or once `stop` is set. Errors that
  // `onError` forgives are reported and counted instead of returned. Under OnError::emit a record
  // that could not be read comes, too, to be passed on: it is not known(), and counts as skipped.
  Result<std::optional<Record>> next();

  // To be asked about a record that was read but cannot be acted on: reports and counts the error
  // and gives success, or gives the error back under OnError::stop. Names the input and place.
  Status forgive(const Record& record, Error error);
  // For what does not count as an error; names the input and place.
  void warn(const Record& record, Error error);
  // From here on what cannot be read is left out without a word, where reading can go on at all.
  void ignoreErrors();

  // Of the end records so far and of `stop`: the gravest status.
  schema::EndStatus status() const;
  uint64_t skipped() const;  // here and, by their end records, upstream
  uint64_t errors() const;   // likewise
  // All three so far, but for `stop`.
  SourceSummary summary() const;
  // Told to stop.
  bool stopped() const;
  // For callers that require the whole input, after the last record. Error: an end record says
  // `interrupted` or `failed`; names its input and place. Not under OnError::stop it is warned of.
  Status checkWhole() const;
  // Warns where an end record says `failed`.
  void warnIfFailed() const;
  // For an error after the last record about something that the input lacks: where an end record
  // says `interrupted` or `failed`, that is the cause, and is the error to report instead.
  Error lacking(Error error) const;
  OnError onError() const;
  // The latest minor version of the headers so far: what is passed on may be of it.
  uint32_t schemaMinor() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// What the header record says about the writer.
struct StreamIdentity {
  std::string tool;
  std::string version;
  uint64_t seed = 0;
};

// After a handler has seen a record.
enum class Then { pass, drop };

class Pipeline {
 public:
  using Handler = std::function<Result<Then>(const Record&)>;

  Pipeline(SourceOptions source, StreamIdentity identity, StreamWriter output);
  Pipeline(Pipeline&&) noexcept;
  ~Pipeline();

  // Writes the header, then gives every record of a known kind to `handle` and passes the others.
  // An error of `handle`, or of passing the record on, is about the record and falls under onError,
  // unless the output failed.
  Status run(const Handler& handle);

  // To be asked about an error that shows only behind `record`, which went out: likewise, but it is
  // not counted as left out. Names its input and place.
  Status forgiveLate(const Record& record, Error error);

  // Records of the tool's own, between those passed through.
  Status write(schema::Record::Reader record);

  // What came of a source of the tool's own: the end record says it with what came of this one.
  void readElsewhere(const SourceSummary& read);

  // The work ended before every query had its verdict (a budget was spent).
  void outOfBudget();

  // Writes the end record and closes the output. `work` is what came of the run, and of what was
  // done since. After an error of either the end record says `failed` and counts it, so that what
  // was finished is not lost; an error before the first record leaves no output at all. Without an
  // error, an input that failed upstream is warned of. Returns the error of `work`, else its own.
  Status finish(Status work = {});

  // run() and finish(), also after an error.
  Status runAndFinish(const Handler& handle);

  StreamWriter& output();
  RecordSource& source();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace obby::io
