// An avatar's centre of mass beside the centre of its root part. A recorded velocity is of the
// former, a recorded position of the latter. They are up to 0.3 studs apart (docs/physics.md,
// body).
#pragma once

#include <span>

#include "calibrate/track.h"
#include "math/angle.h"

namespace obby::calibrate {

struct MassCentre {
  float ahead = 0, right = 0;  // of the root's centre, studs

  bool isRoot() const { return ahead == 0 && right == 0; }
  // From the root's centre, world axes, of an avatar that faces `yaw`.
  Vec3 at(Turns yaw) const;
};

// By least squares over frames in free fall: there the centre of mass moves by the recorded
// velocity, and the root turns about it. Frames that `without` has too do not count. At the root's
// centre if the tracks turn too little in the air to tell. `tracks`: of one avatar.
MassCentre massCentreOf(std::span<const Track* const> tracks, const Track& without,
                        const Params& params);

}  // namespace obby::calibrate
