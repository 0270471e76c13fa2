// The offset of an avatar's centre of mass from the centre of its root part, up to 0.3 studs
// (docs/physics.md, body). A recorded velocity belongs to the centre of mass, a recorded position
// to the root.
#pragma once

#include <span>

#include "calibrate/track.h"
#include "math/angle.h"

namespace obby::calibrate {

struct MassCentre {
  float ahead = 0, right = 0;  // from the root's centre, studs

  bool isRoot() const { return ahead == 0 && right == 0; }
  // Returns the offset from the root's centre in world axes, for an avatar that faces `yaw`.
  Vec3 at(Turns yaw) const;
};

// Fits the offset by least squares over frames in free fall. There the centre of mass moves at the
// recorded velocity and the root turns about it. Frames that are also in `without` do not count.
// Returns a zero offset if the tracks turn too little in the air. `tracks`: all of one avatar.
MassCentre massCentreOf(std::span<const Track* const> tracks, const Track& without,
                        const Params& params);

}  // namespace obby::calibrate
