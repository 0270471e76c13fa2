// What a terminal can show, and text with colours for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace obby::view {

struct TerminalTraits {
  size_t width = 80;   // columns
  bool color = false;  // 24-bit colour sequences are understood
  bool utf8 = false;
};

// Columns of the terminal behind standard output, else of $COLUMNS, else 80.
size_t terminalWidth();
// True if the environment's locale is UTF-8 (LC_ALL, LC_CTYPE, LANG).
bool localeIsUtf8();

struct Rgb {
  uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

// `text` in a colour, or as it is where the terminal has none.
std::string colored(const std::string& text, Rgb color, const TerminalTraits& traits);

}  // namespace obby::view
