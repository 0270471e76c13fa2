// The player's body as an upright box, and its contacts.
#pragma once

#include "geom/shape.h"
#include "math/angle.h"

namespace obby::geom {

// A box that is rotated about Y only.
template <class F>
struct UprightBoxT {
  Vec3T<F> center;
  Vec3T<F> half;
  SinCosT<F> yaw;

  OBBY_DEVICE Mat3T<F> axes() const {
    return {{yaw.cos, 0, -yaw.sin}, {0, 1, 0}, {yaw.sin, 0, yaw.cos}};
  }
  OBBY_DEVICE BoxT<F> bounds() const {
    const F s = absf(yaw.sin), c = absf(yaw.cos);
    const Vec3T<F> e{c * half.x + s * half.z, half.y, s * half.x + c * half.z};
    return {center - e, center + e};
  }
};

using UprightBox = UprightBoxT<float>;

template <class F>
struct ContactT {
  F depth;  // studs; negative when apart
  // Unit; moving the box by depth * normal separates it from the shape; meaningless when apart.
  Vec3T<F> normal;
};

using Contact = ContactT<float>;

}  // namespace obby::geom
