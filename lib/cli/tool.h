// The description of a tool, and the one way to run it:
//   int main(int argc, char** argv) { return obby::cli::runTool(spec(), argc, argv, run); }
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/arguments.h"
#include "cli/options.h"

namespace obby::cli {

class Context;

// A command line that works as written. Help shows the first five, --help-all and the manual page
// show all. A test runs each example in a folder with copies of levels/.
struct Example {
  std::string text;     // "Answer all queries of a level"
  std::string command;  // a shell line: "obby-import tower.rbxlx | obby-solve | obby-view"
};

// A row of a list in the manual page: an exit code or a file, and its meaning.
struct ManualEntry {
  std::string name, text;
};

struct ToolSpec {
  std::string name;     // "obby-solve"
  std::string summary;  // one line, no full stop
  std::vector<Example> examples;
  std::vector<OptionRow> options;
  bool takesInputs = true;  // positional files; standard input if there are none
  // Returns true if the tool reads inputs under these options. Otherwise an input file is an error,
  // and the tool does not wait for a terminal. If null, the tool always reads inputs.
  std::function<bool(const Arguments&)> readsInputs;
  // Records go to standard output, whatever --output says.
  bool alwaysToStandardOutput = false;
  // A terminal gets a table, and records only if --output or --format asks for them.
  bool tableAtTerminal = false;
  std::string inputHelp = "input streams";  // description of the positional files
  std::string notes;                        // paragraphs at the end of help; may be empty
  std::string details;                      // more paragraphs, for --help-all and the manual page
  std::vector<ManualEntry> exitCodes;       // exit codes in addition to those of all tools
  std::vector<ManualEntry> files;           // files that the tool uses without an option
};

// Exit codes. `noSolution` and `unknown` report the verdicts if the user asks for that. An
// interrupted tool exits with 130 or 143, unless it failed.
enum class ExitCode { ok = 0, noSolution = 1, failed = 2, unknown = 3 };

using RunFunction = std::function<Result<ExitCode>(Context&)>;

// Reads the arguments, answers --help and similar options, runs the tool, reports the error that
// `run` returns, and returns the process's exit code. Never throws.
int runTool(const ToolSpec& spec, int argc, char** argv, const RunFunction& run);

}  // namespace obby::cli
