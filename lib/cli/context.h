// What a running tool has: its arguments, its output, and the one place through which it speaks to
// people. All of it is safe to call from several threads.
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

  // Set once by SIGINT or SIGTERM: finish what is done, write the end record, return.
  const std::atomic<bool>& stop() const;

  // Threads to use: --threads, or all that this process may use.
  int threads() const;

  // Error: the file of -o is read, too (written_files.h). The two below begin with it.
  Status checkOutput() const;
  // The stream that -o and --format ask for (standard output, JSON lines).
  Result<io::StreamWriter> openOutput() const;
  // The bytes that -o asks for, for output that is no stream of records.
  Result<io::Sink> openSink() const;

  // True if a table replaces the records: ToolSpec::tableAtTerminal.
  bool showsTable() const;
  // Writes a text for people to standard output, once the progress line is gone.
  Status show(const std::string& text);

  // The inputs, --on-error, the stop flag and this context's reports, for io::RecordSource.
  io::SourceOptions sourceOptions();
  // Tool, version and --seed, for the header record.
  io::StreamIdentity identity() const;

  // `obby-solve: level.jsonl:12: ...` on stderr (JSON with --json-errors). The exit code will be 2.
  void error(const Error& error);
  // Likewise, but the exit code stays; silent with --quiet.
  void warn(const std::string& message);
  // Only with --verbose.
  void note(const std::string& message);
  // The outcome of the run: a line on stderr, or a note object with --json-errors; silent with
  // --quiet.
  void tell(const std::string& message);
  // What the user has to know to go on, on stderr, even with --quiet.
  void say(const std::string& message);
  // Drawn, printed or dropped as --progress says; call it as often as you like.
  void progress(const ProgressState& state);

  // Errors reported so far.
  uint64_t errors() const { return errors_; }
  // Whether to colour text written to -o: a terminal, and nobody said no.
  bool colorOutput() const;

 private:
  const ToolSpec& spec_;
  Arguments arguments_;
  Console& console_;
  std::unique_ptr<Progress> progress_;
  std::atomic<uint64_t> errors_{0};
};

}  // namespace obby::cli
