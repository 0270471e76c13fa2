// Light on what a picture sees.
#pragma once

#include <vector>

#include "view/picture/canvas.h"

namespace obby::view {

// Told apart without colour.
enum class Pattern { plain, stripes, checks };

struct Surface {
  Color color;
  Pattern pattern = Pattern::plain;
};

// Direction to the sun, unit.
Vec3 sunward();

// Colours of all samples of the window, row by row. `sun` is what the sun sees of the same solids;
// `surfaces` by id. Where a solid ends is seen by the samples below and to the right: the last row
// and column of a window that ends within the picture miss that.
std::vector<Color> shade(const Depths& seen, const Depths& sun,
                         const std::vector<Surface>& surfaces);

}  // namespace obby::view
