// The frame of reference of an observation.
#pragma once

#include "math/angle.h"
#include "math/lanes.h"

namespace obby::policy {

// The direction of an observation, and its axes.
struct Frame {
  Turns ahead;
  Vec3 forward, right;

  OBBY_DEVICE explicit Frame(Turns direction)
      : ahead(direction),
        forward(directionOf(sinCos(direction))),
        right{-forward.z, 0, forward.x} {}
};

// Maps v to (-1, 1). The function is odd, and +-0.5 at +-half.
OBBY_DEVICE float squashed(float v, float half) { return v / (absf(v) + half); }

}  // namespace obby::policy
