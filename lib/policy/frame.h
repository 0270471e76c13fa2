// What all numbers of an observation are told in.
#pragma once

#include "math/angle.h"
#include "math/lanes.h"

namespace obby::policy {

// The direction that an observation looks in, and its axes.
struct Frame {
  Turns ahead;
  Vec3 forward, right;

  OBBY_DEVICE explicit Frame(Turns direction)
      : ahead(direction),
        forward(directionOf(sinCos(direction))),
        right{-forward.z, 0, forward.x} {}
};

// Odd, and between -1 and 1; +-0.5 at +-half.
OBBY_DEVICE float squashed(float v, float half) { return v / (absf(v) + half); }

}  // namespace obby::policy
