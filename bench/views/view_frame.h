// What all other ways to see have in common.
#pragma once

#include "policy/observation.h"

namespace obby::bench {

// Fills `inputs` (kInputs) with all that is not in the maps, and the place of those with
// kEmptyInput. Gives the direction that the frame looks in.
Turns observeAllButMaps(const policy::Scene& scene, const sim::World& world,
                        const sim::LooseBody* loose, float* inputs);

// The solid from `origin`, in coordinates along `axes`: unit vectors at right angles.
policy::Solid along(const Mat3& axes, Vec3 origin, policy::Solid solid);

}  // namespace obby::bench
