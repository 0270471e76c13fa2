// A small picture of terminal characters, seen from above. Each pixel has a glyph for terminals
// without colours and a colour for the others.
#pragma once

#include <string>
#include <vector>

#include "math/vec.h"
#include "table/terminal.h"

namespace obby::view {

struct Vec2 {
  float x = 0, y = 0;
};

// Returns the counter-clockwise convex hull, with fewer than 3 points if all are collinear.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

struct Ink {
  char glyph;        // ' ' is the background
  const char* wide;  // the glyph where UTF-8 is allowed
  table::Rgb color;
};

// Pixels are square in world units. With colours and UTF-8, two pixels share a character (half
// blocks). Otherwise a character is one pixel of double height.
class Raster {
 public:
  // `lo` to `hi`: the world rectangle shown, x to the right and y down. `width` is in characters.
  Raster(Vec2 lo, Vec2 hi, size_t width, size_t maxRows, const table::TerminalTraits& terminal);

  void fill(const std::vector<Vec2>& hull, const Ink& ink);
  void line(Vec2 a, Vec2 b, const Ink& ink);
  void dot(Vec2 at, const Ink& ink);
  std::string text() const;

  float pixelWidth() const { return pixel_.x; }  // studs
  size_t columns() const { return columns_; }

 private:
  void put(long column, long row, const Ink& ink);
  std::string coloredRow(size_t row) const;
  std::string plainRow(size_t row) const;

  table::TerminalTraits terminal_;
  bool halves_;  // two pixels per character
  Vec2 lo_, pixel_;
  size_t columns_ = 0, rows_ = 0;  // pixels
  std::vector<Ink> pixels_;
};

}  // namespace obby::view
