// The filter at the core of every tool. It reads the records of several inputs in order, and
// replaces their framing by its own. Records that the tool does not handle pass unchanged.
//
//   io::Pipeline pipeline(context.sourceOptions(), context.identity(), std::move(output));
//   return pipeline.runAndFinish([&](const io::Record& record) -> Result<io::Then> {
//     if (record.which() != io::Kind::QUERY) return io::Then::pass;
//     ... pipeline.write(answer.reader()) ...
//     return io::Then::pass;  // writes the query after its answers; io::Then::drop leaves it out
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

// The reaction to a record that cannot be read or handled. Broken framing (a truncated stream,
// another schema version) and a failing output always stop.
enum class OnError {
  stop,  // report the error and end
  skip,  // report the error, leave the record out, go on
  emit,  // report the error, pass the record on unchanged, go on
};

struct SourceOptions {
  std::vector<std::string> inputs = {"-"};
  OnError onError = OnError::stop;
  const std::atomic<bool>* stop = nullptr;        // set from outside to end the input early
  std::function<void(const Error&)> report = {};  // errors that did not stop the run
  // Receives fields and kinds that look misspelt, the first few of a run.
  std::function<void(const Error&)> warn = {};
  // Opens an input as a stream of records; StreamReader::open if absent. A tool that reads files
  // other than streams converts them here.
  std::function<Result<StreamReader>(const std::string& path)> open = {};
};

// The status and counts of an end record, about the records before it.
struct SourceSummary {
  schema::EndStatus status = schema::EndStatus::COMPLETE;
  uint64_t skipped = 0, errors = 0;

  // Adds another summary. The more severe status counts.
  void add(const SourceSummary& other);
};

// The records of several inputs, one after another, without headers and ends.
class RecordSource {
 public:
  explicit RecordSource(SourceOptions options);
  RecordSource(RecordSource&&) noexcept;
  ~RecordSource();

  // Returns the next record, or nothing at the end of the last input or once `stop` is set. Errors
  // that `onError` forgives are reported and counted instead of returned. Under OnError::emit a
  // record that could not be read is also returned, so that it can be passed on. It is not known(),
  // and counts as skipped.
  Result<std::optional<Record>> next();

  // Handles an error about a record that was read but cannot be handled. Reports and counts it and
  // returns success, or returns it under OnError::stop. Adds the input and place.
  Status forgive(const Record& record, Error error);
  // Reports a problem that does not count as an error. Adds the input and place.
  void warn(const Record& record, Error error);
  // From now on, silently leaves out records that cannot be read, if reading can continue at all.
  void ignoreErrors();

  // Returns the most severe status of the end records so far and of `stop`.
  schema::EndStatus status() const;
  uint64_t skipped() const;  // records skipped here and, according to end records, upstream
  uint64_t errors() const;   // errors here and upstream
  // Returns status, skipped and errors so far, regardless of `stop`.
  SourceSummary summary() const;
  // Returns true if `stop` is set, or has ended the input.
  bool stopped() const;
  // Callers that require the whole input call this after the last record. Returns an error if an
  // end record says `interrupted` or `failed`, with its input and place. Only warns unless
  // OnError::stop is set.
  Status checkWhole() const;
  // Warns if an end record says `failed`.
  void warnIfFailed() const;
  // Returns the error to report for something that the input lacks. If an end record says
  // `interrupted` or `failed`, the returned error names that as the cause. Call it after the last
  // record.
  Error lacking(Error error) const;
  OnError onError() const;
  // Returns the latest minor schema version of the headers so far. Records to pass on may have this
  // version.
  uint32_t schemaMinor() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The identity of the writer in the header record.
struct StreamIdentity {
  std::string tool;
  std::string version;
  uint64_t seed = 0;
};

// A handler's decision about a record.
enum class Then { pass, drop };

class Pipeline {
 public:
  using Handler = std::function<Result<Then>(const Record&)>;

  Pipeline(SourceOptions source, StreamIdentity identity, StreamWriter output);
  Pipeline(Pipeline&&) noexcept;
  ~Pipeline();

  // Writes the header, then gives every record of a known kind to `handle` and passes the others
  // on. An error of `handle`, or of passing the record on, is about the record and is subject to
  // onError, unless the output failed.
  Status run(const Handler& handle);

  // Handles an error that shows only after `record` was written. It is subject to onError, but the
  // record does not count as left out. Adds its input and place.
  Status forgiveLate(const Record& record, Error error);

  // Writes a record of the tool's own, between those passed on.
  Status write(schema::Record::Reader record);

  // Adds the summary of another source, which the tool has read itself, to the end record.
  void readElsewhere(const SourceSummary& read);

  // Notes that a budget was spent before every query had its verdict.
  void outOfBudget();

  // Writes the end record and closes the output. `work` is the status of the run and of what was
  // done since. After an error of either, the end record says `failed` and counts it, so that
  // finished results are not lost; an error before the first record leaves no output at all.
  // Without an error, warns of an input that failed upstream. Returns the error of `work`, or else
  // that of finishing.
  Status finish(Status work = {});

  // Calls run() and finish(), also after an error.
  Status runAndFinish(const Handler& handle);

  StreamWriter& output();
  RecordSource& source();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace obby::io
