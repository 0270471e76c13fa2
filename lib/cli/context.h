// The environment of a running tool: its arguments, its output, and the only place through which it
// reports to users. Thread-safe.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>

#include "base/result.h"
#include "cli/arguments.h"
#include "cli/progress.h"
#include "cli/tool.h"
#include "io/pipeline.h"
#include "io/sink.h"
#include "io/stream.h"

namespace obby::cli {

class Console;

class Context {
 public:
  Context(const ToolSpec& spec, Arguments arguments, Console& console);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Arguments& arguments() const { return arguments_; }
  const std::vector<std::string>& inputs() const { return arguments_.inputs; }

  // Returns the flag that SIGINT or SIGTERM sets. The tool then completes its results, writes the
  // end record and returns.
  const std::atomic<bool>& stop() const;

  // Returns the threads to use: --threads, or all that this process may use.
  int threads() const;

  // Returns an error if the file of -o is also read (written_files.h). The next two call it first.
  Status checkOutput() const;
  // Opens the stream that -o and --format ask for (standard output, JSON lines).
  Result<io::StreamWriter> openOutput() const;
  // Opens the bytes that -o asks for, for output that is not a stream of records.
  Result<io::Sink> openSink() const;

  // Returns true if a table replaces the records: ToolSpec::tableAtTerminal.
  bool showsTable() const;
  // Writes a text for users to standard output, after the progress line is removed.
  Status show(const std::string& text);

  // Returns the inputs, --on-error, the stop flag and this context's reports, for io::RecordSource.
  io::SourceOptions sourceOptions();
  // Returns tool, version and --seed, for the header record.
  io::StreamIdentity identity() const;

  // Prints `obby-solve: level.jsonl:12: ...` on stderr (JSON with --json-errors). The exit code
  // will be 2.
  void error(const Error& error);
  // Prints a warning, which does not change the exit code. Silent with --quiet.
  void warn(const std::string& message);
  // Prints a note if --verbose is set.
  void note(const std::string& message);
  // Prints the outcome of the run: a line on stderr, or a note object with --json-errors. Silent
  // with --quiet.
  void tell(const std::string& message);
  // Prints a message that the user needs to continue, on stderr, even with --quiet.
  void say(const std::string& message);
  // Draws, prints or drops the progress, as --progress says. May be called at any rate.
  void progress(const ProgressState& state);

  // Returns the number of errors reported so far.
  uint64_t errors() const { return errors_; }
  // Returns true if text written to -o gets colours: the output is a terminal, and colours are not
  // turned off.
  bool colorOutput() const;

 private:
  const ToolSpec& spec_;
  Arguments arguments_;
  Console& console_;
  std::unique_ptr<Progress> progress_;
  std::atomic<uint64_t> errors_{0};
};

}  // namespace obby::cli
