// What a tool is to its user, and the one way to run it:
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

// A command line that works as it stands; help shows the first five, --help-all and the manual page
// all of them. A test runs each in a folder that holds copies of levels/.
struct Example {
  std::string text;     // "Answer all queries of a level"
  std::string command;  // a shell line: "obby-import tower.rbxlx | obby-solve | obby-view"
};

// A row of a list in the manual page: an exit code or a file, and what it means.
struct ManualEntry {
  std::string name, text;
};

struct ToolSpec {
  std::string name;     // "obby-solve"
  std::string summary;  // one line, no full stop
  std::vector<Example> examples;
  std::vector<OptionRow> options;
  bool takesInputs = true;  // positional files; standard input when none
  // Do these options leave anything to be read? Where they do not, a file is refused and a terminal
  // is not waited for. Null: they always do.
  std::function<bool(const Arguments&)> readsInputs;
  // Records go to standard output whatever --output says.
  bool alwaysToStandardOutput = false;
  // At a terminal it shows a table, and records only where --output or --format asks for them.
  bool tableAtTerminal = false;
  std::string inputHelp = "input streams";  // what the positional files are
  std::string notes;                        // paragraphs at the end of help; may be empty
  std::string details;                      // more of them, for --help-all and the manual page
  std::vector<ManualEntry> exitCodes;       // besides those that all tools have
  std::vector<ManualEntry> files;           // that it uses unasked
};

// design.md section 5. An interrupted tool ends with 130 or 143, whatever it returned below 2.
enum class ExitCode { ok = 0, noSolution = 1, failed = 2, unknown = 3 };

using RunFunction = std::function<Result<ExitCode>(Context&)>;

// Reads the arguments, answers --help and its like, runs, reports an error that `run` returns, and
// gives the process's exit code. Never throws.
int runTool(const ToolSpec& spec, int argc, char** argv, const RunFunction& run);

}  // namespace obby::cli
