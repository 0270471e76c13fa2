// Tells what a terminal can show, and colours text for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace obby::table {

struct TerminalTraits {
  size_t width = 80;   // columns
  bool color = false;  // the terminal understands colour sequences
  bool utf8 = false;
  bool palette = false;  // colours are limited to xterm's 256; otherwise they have 24 bits
};

// Returns the columns of the terminal behind standard output, otherwise $COLUMNS, otherwise 80.
size_t terminalWidth();
// Returns true if the environment's locale is UTF-8 (LC_ALL, LC_CTYPE, LANG).
bool localeIsUtf8();
// Returns true if the terminal says that it knows colours of 24 bits (COLORTERM, TERM). Other
// terminals may take their numbers for something else.
bool terminalHasRgb();
// Returns all of these traits. `color` is the user's wish.
TerminalTraits terminalTraits(bool color);

struct Rgb {
  uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

enum class Layer { front, back };

// Returns the sequence that gives the following text that colour, for a terminal with colours.
std::string colorSequence(Layer layer, Rgb color, const TerminalTraits& traits);

// Returns `text` in a colour, or unchanged if the terminal has no colours.
std::string colored(const std::string& text, Rgb color, const TerminalTraits& traits);

}  // namespace obby::table
