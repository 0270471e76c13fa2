// The player's body as an upright box, and what a contact with it is.
#pragma once

#include "geom/shape.h"
#include "math/angle.h"

namespace obby::geom {

// A box that stands upright: turned about Y only.
struct UprightBox {
  Vec3 center;
  Vec3 half;
  SinCos yaw;

  OBBY_DEVICE Mat3 axes() const {
    return {{yaw.cos, 0, -yaw.sin}, {0, 1, 0}, {yaw.sin, 0, yaw.cos}};
  }
  OBBY_DEVICE Box bounds() const {
    const float s = absf(yaw.sin), c = absf(yaw.cos);
    const Vec3 e{c * half.x + s * half.z, half.y, s * half.x + c * half.z};
    return {center - e, center + e};
  }
};

struct Contact {
  float depth;  // studs; negative: apart
  Vec3 normal;  // unit; moving the box by depth * normal separates them. Meaningless where they are
                // apart.
};

}  // namespace obby::geom
