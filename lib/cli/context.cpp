#include "cli/context.h"

#include <unistd.h>

#include "base/thread_pool.h"
#include "cli/console.h"
#include "cli/stop.h"
#include "cli/written_files.h"
#include "io/version.h"

namespace obby::cli {
namespace {

std::string textOr(const Arguments& arguments, const std::string& name,
                   const std::string& otherwise) {
  const auto found = arguments.values.find(name);
  if (found == arguments.values.end() || found->second.texts.empty()) return otherwise;
  return found->second.texts.back();
}

bool toStandardOutput(const ToolSpec& spec, const Arguments& arguments) {
  return spec.alwaysToStandardOutput || textOr(arguments, "output", "-") == "-";
}

bool given(const Arguments& arguments, const std::string& name) {
  const auto found = arguments.values.find(name);
  return found != arguments.values.end() && found->second.given;
}

bool tableAsked(const ToolSpec& spec, const Arguments& arguments) {
  if (!spec.tableAtTerminal || isatty(STDOUT_FILENO) != 1) return false;
  return !given(arguments, "output") && !given(arguments, "format");
}

// Records on the same terminal would break a line that is drawn repeatedly.
bool canDraw(const ToolSpec& spec, const Arguments& arguments) {
  if (isatty(STDERR_FILENO) != 1) return false;
  return !toStandardOutput(spec, arguments) || isatty(STDOUT_FILENO) != 1 ||
         tableAsked(spec, arguments);
}

io::OnError onErrorFor(const std::string& text) {
  if (text == "skip") return io::OnError::skip;
  return text == "emit" ? io::OnError::emit : io::OnError::stop;
}

}  // namespace

Context::Context(const ToolSpec& spec, Arguments arguments, Console& console)
    : spec_(spec), arguments_(std::move(arguments)), console_(console) {
  const ProgressMode mode = progressMode(textOr(arguments_, "progress", "none"),
                                         canDraw(spec_, arguments_), console_.quiet);
  progress_ = std::make_unique<Progress>(mode, console_);
}

Context::~Context() = default;

const std::atomic<bool>& Context::stop() const { return stopFlag(); }

int Context::threads() const {
  const auto wanted = arguments_.values.count("threads") ? arguments_.integer("threads") : 0;
  return wanted > 0 ? int(wanted) : availableThreads();
}

Status Context::checkOutput() const {
  const WrittenFile written[] = {{"output", textOr(arguments_, "output", "-")}};
  return refuseOverwriting(arguments_, written);
}

Result<io::StreamWriter> Context::openOutput() const {
  OBBY_RETURN_IF_ERROR(checkOutput());
  const std::string path = textOr(arguments_, "output", "-");
  const std::string format = textOr(arguments_, "format", "");
  if (format.empty()) return io::StreamWriter::open(path, io::formatForFile(path), &stopFlag());
  OBBY_ASSIGN(const io::Format chosen, io::parseFormat(format));
  return io::StreamWriter::open(path, chosen, &stopFlag());
}

Result<io::Sink> Context::openSink() const {
  OBBY_RETURN_IF_ERROR(checkOutput());
  return io::Sink::open(textOr(arguments_, "output", "-"), io::Durable::no, &stopFlag());
}

bool Context::showsTable() const { return tableAsked(spec_, arguments_); }

Status Context::show(const std::string& text) {
  progress_->hide();
  OBBY_ASSIGN(io::Sink sink, io::Sink::open("-", io::Durable::no, &stopFlag()));
  OBBY_RETURN_IF_ERROR(sink.write(text));
  return sink.close();
}

io::SourceOptions Context::sourceOptions() {
  io::SourceOptions out;
  out.inputs = arguments_.inputs;
  out.onError = onErrorFor(textOr(arguments_, "on-error", "stop"));
  out.stop = &stopFlag();
  out.report = [this](const Error& problem) { error(problem); };
  out.warn = [this](const Error& slip) { warn(slip.text()); };
  return out;
}

io::StreamIdentity Context::identity() const {
  return {spec_.name, io::toolVersion(), arguments_.values.count("seed") ? arguments_.seed() : 0};
}

void Context::error(const Error& error) {
  errors_++;
  console_.error(error);
}

void Context::warn(const std::string& message) { console_.warn(message); }
void Context::note(const std::string& message) { console_.note(message); }
void Context::tell(const std::string& message) { console_.tell(message); }
void Context::say(const std::string& message) { console_.line(spec_.name + ": " + message); }
void Context::progress(const ProgressState& state) { progress_->update(state); }

bool Context::colorOutput() const {
  return textOr(arguments_, "output", "-") == "-" && !arguments_.flag("no-color") &&
         colorsOn(STDOUT_FILENO);
}

}  // namespace obby::cli
