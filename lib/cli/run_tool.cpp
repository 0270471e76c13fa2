// Runs a tool, from argv to the exit code.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "cli/check_value.h"
#include "cli/completion.h"
#include "cli/console.h"
#include "cli/context.h"
#include "cli/help.h"
#include "cli/manual.h"
#include "cli/parse.h"
#include "cli/stop.h"
#include "cli/variables.h"
#include "io/read_file.h"
#include "io/text.h"

namespace obby::schema {
extern const char* const kText;  // the schema's source, from schema/CMakeLists.txt
}

namespace obby::cli {
namespace {

// Occupies closed standard streams. Otherwise a file opened later could get the descriptor of a
// closed stream and receive its data. The placeholder is opened in the wrong direction, so that
// using the stream remains an error.
void occupyStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)
      open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

// Reports an error that ends the tool. A reader that went away, or a signal, is not reported.
int fail(Console& console, const Error& error) {
  if (io::isBrokenPipe(error)) return kSignalExit + SIGPIPE;
  if (io::isInterrupted(error) && stopSignal() != 0) return kSignalExit + stopSignal();
  console.error(error);
  return int(ExitCode::failed);
}

int print(Console& console, const std::string& text) {
  auto sink = io::Sink::open("-");
  if (!sink) return fail(console, sink.error());
  if (Status status = sink->write(text); !status) return fail(console, status.error());
  if (Status status = sink->close(); !status) return fail(console, status.error());
  return int(ExitCode::ok);
}

int finalCode(const Context& context, ExitCode code) {
  if (context.errors() > 0) code = ExitCode::failed;
  if (stopSignal() != 0 && code != ExitCode::failed) return kSignalExit + stopSignal();
  return int(code);
}

// Answers --help and similar options. Returns the exit code, or a negative number if none is set.
int answer(const ToolSpec& spec, const std::vector<OptionRow>& rows, const CommandLine& line,
           Console& console) {
  if (line.flag("help") || line.flag("help-all"))
    return print(console, helpText(spec, rows, {helpWidth(STDOUT_FILENO), line.flag("help-all")}));
  if (!line.wrong) return -1;
  if (line.flag("version")) return print(console, versionLine(spec) + "\n");
  if (line.flag("schema")) return print(console, schema::kText);
  if (line.flag("man")) return print(console, manualPage(spec, rows));
  return -1;
}

int run(const ToolSpec& spec, int argc, char** argv, const RunFunction& body, Console& console) {
  const std::vector<OptionRow> rows = allRows(spec);
  const CommandLine line = parseCommandLine(spec, rows, argc, argv);
  if (const int code = answer(spec, rows, line, console); code >= 0) return code;
  auto arguments = resolveArguments(spec, rows, line);
  if (!arguments) return fail(console, arguments.error());
  console.jsonErrors = arguments->flag("json-errors");
  console.quiet = arguments->flag("quiet");
  console.verbose = arguments->flag("verbose");
  console.color = !arguments->flag("no-color") && colorsOn(STDERR_FILENO);
  if (arguments->has("completion"))
    return print(console, completionScript(spec, rows, arguments->text("completion")));
  for (const MisspeltVariable& slip : misspeltVariables(rows, environ))
    console.warn(
        fmt::format("{}: no option has this name (did you mean {}?)", slip.name, slip.meant));
  if (arguments->flag("print-config")) return print(console, configText(spec, rows, *arguments));
  const bool reads = spec.takesInputs && (!spec.readsInputs || spec.readsInputs(*arguments));
  if (!reads && !line.inputs.empty())
    return fail(console, makeError("unexpected argument " + io::quoted(line.inputs.front()),
                                   "the tool reads no input with these options"));
  if (reads && line.inputs.empty() && isatty(STDIN_FILENO) == 1) {
    console.line(shortHelp(spec, helpWidth(STDERR_FILENO)));
    return int(ExitCode::failed);
  }
  if (!reads) arguments->inputs.clear();
  installStopHandlers();
  Context context(spec, std::move(*arguments), console);
  const Result<ExitCode> code = body(context);
  if (!code) return fail(console, code.error());
  return finalCode(context, *code);
}

// Returns true if --json-errors is set. Needed before the arguments are parsed.
bool wantsJsonErrors(int argc, char** argv) {
  for (int i = 1; i < argc; i++)
    if (std::strcmp(argv[i], "--json-errors") == 0) return true;
  const char* variable = std::getenv(environmentName("json-errors").c_str());
  std::string text = variable ? variable : "";
  return !checkValue(OptionRow{}, text) && text == "true";  // a default row is a flag
}

}  // namespace

int runTool(const ToolSpec& spec, int argc, char** argv, const RunFunction& body) {
  occupyStandardStreams();
  Console console(spec.name);
  console.jsonErrors = wantsJsonErrors(argc, argv);
  try {
    return run(spec, argc, argv, body, console);
  } catch (const std::bad_alloc&) {
    return fail(console, makeError("not enough memory",
                                   "free some memory, or raise the limit if ulimit -v shows one"));
  } catch (const std::exception& e) {
    return fail(console, makeError(std::string("internal error: ") + e.what()));
  }
}

}  // namespace obby::cli
