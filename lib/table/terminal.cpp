// Asks the terminal and the environment what they can show.
#include "table/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace obby::table {
namespace {

constexpr size_t kMinWidth = 40, kMaxWidth = 400;

size_t sane(long width) {
  return width < long(kMinWidth) ? kMinWidth : width > long(kMaxWidth) ? kMaxWidth : size_t(width);
}

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

int distance(Rgb a, Rgb b) {
  const int red = a.r - b.r, green = a.g - b.g, blue = a.b - b.b;
  return red * red + green * green + blue * blue;
}

// Returns the nearest of xterm's colours 16 to 255: a cube of six steps each way, then 24 greys.
int nearestInPalette(Rgb color) {
  constexpr uint8_t kSteps[] = {0, 95, 135, 175, 215, 255};
  const auto step = [&](uint8_t v) {
    int best = 0;
    for (int i = 1; i < 6; ++i) {
      if (std::abs(kSteps[i] - v) < std::abs(kSteps[best] - v)) best = i;
    }
    return best;
  };
  const int red = step(color.r), green = step(color.g), blue = step(color.b);
  const int grey = std::clamp(((color.r + color.g + color.b) / 3 - 3) / 10, 0, 23);
  const auto light = uint8_t(8 + 10 * grey);
  const Rgb cube{kSteps[red], kSteps[green], kSteps[blue]};
  if (distance(color, {light, light, light}) < distance(color, cube)) return 232 + grey;
  return 16 + 36 * red + 6 * green + blue;
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

bool terminalHasRgb() {
  const std::string_view colors = variable("COLORTERM");
  return colors == "truecolor" || colors == "24bit" ||
         variable("TERM").find("direct") != std::string_view::npos;
}

TerminalTraits terminalTraits(bool color) {
  return {terminalWidth(), color, localeIsUtf8(), !terminalHasRgb()};
}

std::string colorSequence(Layer layer, Rgb color, const TerminalTraits& traits) {
  const int code = layer == Layer::front ? 38 : 48;
  if (traits.palette) return fmt::format("\x1b[{};5;{}m", code, nearestInPalette(color));
  return fmt::format("\x1b[{};2;{};{};{}m", code, color.r, color.g, color.b);
}

std::string colored(const std::string& text, Rgb color, const TerminalTraits& traits) {
  if (!traits.color) return text;
  return colorSequence(Layer::front, color, traits) + text + "\x1b[0m";
}

}  // namespace obby::table
