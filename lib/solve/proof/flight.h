// How far a player can come in one flight, at most: from leaving what carries the player to the
// next thing that can. Inflated: every simplification is in the player's favour.
#pragma once

#include "level/params.h"
#include "math/vec.h"

namespace obby::solve {

// Where and how fast a flight can begin.
struct Launch {
  Box from;      // feet, at the highest: hi.y
  float upward;  // studs/s
};

class Flight {
 public:
  // `sideways`: fastest horizontal motion there is, studs/s.
  Flight(const Params& params, float sideways) : p_(&params), sideways_(sideways) {}

  // Highest the feet can come.
  float apex(const Launch& l) const {
    return l.from.hi.y + l.upward * l.upward / (2 * p_->gravity);
  }

  // Studs sideways until the feet are as low as `height`; negative: they never are as high.
  float reach(const Launch& l, float height) const {
    const float drop = l.from.hi.y - height;
    if (apex(l) < height) return -1;
    const float end2 = l.upward * l.upward + 2 * p_->gravity * drop;
    float seconds = (l.upward + sqrtf32(maxf(end2, 0.0f))) / p_->gravity;
    const float fastest = p_->maxFallSpeed;
    if (end2 > fastest * fastest) {  // falls no faster than that
      const float fallen = (fastest * fastest - l.upward * l.upward) / (2 * p_->gravity);
      seconds = (l.upward + fastest) / p_->gravity + (drop - fallen) / fastest;
    }
    // A jump can come a little after the floor has ended; ticks are whole.
    const float late = p_->coyoteTime + 2 * p_->tickSeconds;
    return sideways_ * (seconds + late);
  }

  float sideways() const { return sideways_; }

 private:
  const Params* p_;
  float sideways_;
};

// Studs between two boxes seen from above.
inline float gapBetween(const Box& a, const Box& b) {
  const float x = maxf(maxf(a.lo.x - b.hi.x, b.lo.x - a.hi.x), 0.0f);
  const float z = maxf(maxf(a.lo.z - b.hi.z, b.lo.z - a.hi.z), 0.0f);
  return sqrtf32(x * x + z * z);
}

inline bool isWithin(const Box& inner, const Box& outer) {
  const Box all = join(inner, outer);
  return all.lo == outer.lo && all.hi == outer.hi;
}

}  // namespace obby::solve
