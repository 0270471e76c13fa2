// Lighting of the visible solids.
#pragma once

#include <vector>

#include "view/picture/canvas.h"

namespace obby::view {

// Patterns are distinguishable without colour.
enum class Pattern { plain, stripes, checks };

struct Surface {
  Color color;
  Pattern pattern = Pattern::plain;
};

// Returns the direction to the sun, unit.
Vec3 sunward();

// Returns the colours of all samples of the window, row by row. `sun` is the sun's depth buffer of
// the same solids; `surfaces` is indexed by id. Edges depend on the samples below and to the right.
// In a window that ends within the picture, the last row and column miss them.
std::vector<Color> shade(const Depths& seen, const Depths& sun,
                         const std::vector<Surface>& surfaces);

}  // namespace obby::view
