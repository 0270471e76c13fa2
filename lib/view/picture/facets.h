// The flat faces of a solid.
#pragma once

#include <vector>

#include "view/picture/canvas.h"

namespace obby::view {

struct Facet {
  Vec3 normal;                // unit, outward
  std::vector<Vec3> corners;  // in no particular order
};

// Returns the faces in world space, or nothing for a round shape.
std::vector<Facet> facetsOf(const Solid& solid);

}  // namespace obby::view
