#include "cli/console.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <string>

#include "cli/stop.h"
#include "io/sink.h"
#include "io/text.h"

namespace obby::cli {
namespace {

constexpr const char* kClearLine = "\r\x1b[K";

// Nothing in a message may move the cursor or forge another line.
std::string harmless(std::string text) {
  for (char& c : text)
    if (uint8_t(c) < 0x20 || c == 0x7f) c = '?';
  return text;
}

void member(std::string& out, const char* name, const std::string& value) {
  if (value.empty()) return;
  out += std::string(",\"") + name + "\":" + io::quoted(value, SIZE_MAX);
}

}  // namespace

bool colorsOn(int descriptor) {
  const char* no = std::getenv("NO_COLOR");
  const char* term = std::getenv("TERM");
  if (no && *no) return false;
  if (term && std::string_view(term) == "dumb") return false;
  return isatty(descriptor) == 1;
}

void Console::error(const Error& error) { message("error", error); }

void Console::warn(const std::string& text) {
  if (!quiet) message("warning", makeError(text));
}

void Console::note(const std::string& text) {
  if (verbose && !quiet) message("note", makeError(text));
}

void Console::message(const char* level, const Error& error) {
  if (jsonErrors) {
    std::string out = std::string("{\"type\":\"") + level + "\",\"tool\":\"" + tool_ + '"';
    member(out, "input", error.input);
    member(out, "place", error.place);
    member(out, "path", error.path);
    member(out, "message", error.message);
    member(out, "hint", error.hint);
    return line(out + "}");
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

size_t Console::width() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

void Console::put(std::string_view text) {
  while (!text.empty() && !unheard_) {
    const bool ends = stopFlag().load();
    unheard_ = ends && !io::takesMore(STDERR_FILENO, io::kPatienceMilliseconds);
    if (unheard_) return;
    const size_t most = ends ? std::min<size_t>(text.size(), PIPE_BUF) : text.size();
    const ssize_t sent = ::write(STDERR_FILENO, text.data(), most);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return;  // nowhere left to complain
    text.remove_prefix(size_t(sent));
  }
}

}  // namespace obby::cli
