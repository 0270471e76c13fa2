// What a terminal can show, and text with colours for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace obby::table {

struct TerminalTraits {
  size_t width = 80;   // columns
  bool color = false;  // colour sequences are understood
  bool utf8 = false;
  bool palette = false;  // these are of the 256 colours that xterm has, else of 24 bits
};

// Columns of the terminal behind standard output, else of $COLUMNS, else 80.
size_t terminalWidth();
// True if the environment's locale is UTF-8 (LC_ALL, LC_CTYPE, LANG).
bool localeIsUtf8();
// True if the terminal says that it knows colours of 24 bits (COLORTERM, TERM): others may take
// their numbers for something else.
bool terminalHasRgb();
// All of that; `color` is what the user wants.
TerminalTraits terminalTraits(bool color);

struct Rgb {
  uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

enum class Layer { front, back };

// The sequence that makes what follows it that colour, on a terminal that has colours.
std::string colorSequence(Layer layer, Rgb color, const TerminalTraits& traits);

// `text` in a colour, or as it is where the terminal has none.
std::string colored(const std::string& text, Rgb color, const TerminalTraits& traits);

}  // namespace obby::table
