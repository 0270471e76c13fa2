// Asks the terminal and the environment.
#include "view/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace obby::view {
namespace {

constexpr size_t kLeastWidth = 40, kMostWidth = 400;

size_t sane(long width) {
  return width < long(kLeastWidth)  ? kLeastWidth
         : width > long(kMostWidth) ? kMostWidth
                                    : size_t(width);
}

}  // namespace

size_t terminalWidth() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return sane(size.ws_col);
  const char* columns = std::getenv("COLUMNS");
  const long given = columns != nullptr ? std::strtol(columns, nullptr, 10) : 0;
  return given > 0 ? sane(given) : 80;
}

bool localeIsUtf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value == nullptr || *value == 0) continue;
    const std::string_view text(value);
    return text.find("UTF-8") != text.npos || text.find("utf8") != text.npos ||
           text.find("utf-8") != text.npos || text.find("UTF8") != text.npos;
  }
  return false;
}

std::string colored(const std::string& text, Rgb color, const TerminalTraits& traits) {
  if (!traits.color) return text;
  return fmt::format("\x1b[38;2;{};{};{}m{}\x1b[0m", color.r, color.g, color.b, text);
}

}  // namespace obby::view
