#include "cli/console.h"

#include <signal.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "cli/stop.h"
#include "io/json_writer.h"
#include "io/sink.h"
#include "io/text.h"
#include "io/utf8.h"

namespace obby::cli {
namespace {

constexpr const char* kClearLine = "\r\x1b[K";

// Replaces characters of a message that could move the cursor, forge a line or reverse this one.
// The replacement stays visible.
std::string harmless(std::string_view text) { return io::tamed(text, false, '?'); }

// While this object lives, writing to a pipe without a reader fails instead of ending the process,
// since the tool's output may have another reader.
class PipeSignalHeld {
 public:
  PipeSignalHeld() {
    sigset_t pending;
    sigpending(&pending);
    wasPending_ = sigismember(&pending, SIGPIPE) == 1;
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~PipeSignalHeld() {
    const timespec atOnce{};
    while (!wasPending_ && sigtimedwait(&pipe_, nullptr, &atOnce) < 0 && errno == EINTR) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  PipeSignalHeld(const PipeSignalHeld&) = delete;
  PipeSignalHeld& operator=(const PipeSignalHeld&) = delete;

 private:
  sigset_t pipe_, before_;
  bool wasPending_;
};

void writeShown(io::JsonWriter& out, const char* name, const std::string& value) {
  if (!value.empty()) out.key(name).raw(io::quoted(value, SIZE_MAX));
}

// Returns true if `path` is an option or a variable. Errors about options have one of these in
// place of a path in a record.
bool namesOption(std::string_view path) {
  return path.starts_with('-') || path.starts_with("OBBY_");
}

}  // namespace

bool colorsOn(int descriptor) {
  const char* no = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  if (no && *no) return false;
  if (term && std::string_view(term) == "dumb") return false;
  return isatty(descriptor) == 1;
}

size_t terminalWidth(int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

void Console::error(const Error& error) { message("error", error); }

void Console::warn(const std::string& text) {
  if (!quiet) message("warning", makeError(text));
}

void Console::note(const std::string& text) {
  if (verbose && !quiet) message("note", makeError(text));
}

void Console::tell(const std::string& text) {
  if (quiet) return;
  if (jsonErrors) return message("note", makeError(text));
  line(tool_ + ": " + harmless(text));
}

void Console::message(const char* level, const Error& error) {
  if (jsonErrors) {
    io::JsonWriter out;
    out.open('{').field("type", level).field("tool", tool_);
    writeShown(out, "input", error.input);
    writeShown(out, "place", error.place);
    writeShown(out, namesOption(error.path) ? "option" : "path", error.path);
    writeShown(out, "message", error.message);
    writeShown(out, "hint", error.hint);
    return line(out.finish());
  }
  const bool isError = std::string_view(level) == "error";
  const std::string name = color && isError ? "\x1b[1;31m" + tool_ + "\x1b[0m" : tool_;
  const std::string prefix = isError ? "" : std::string(level) + ": ";
  line(name + ": " + prefix + harmless(error.text()));
}

void Console::line(std::string_view text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string out = drawn_ ? kClearLine : "";
  drawn_ = false;
  put((out += text) += '\n');
}

void Console::status(const std::string& text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (text.empty() && !drawn_) return;
  drawn_ = !text.empty();
  put(kClearLine + harmless(text));
}

void Console::put(std::string_view text) {
  const PipeSignalHeld held;
  if (unheard_ || io::sendAll(STDERR_FILENO, text, &stopFlag())) return;
  unheard_ = errno == EINTR;  // other errors cannot be reported anywhere
}

}  // namespace obby::cli
