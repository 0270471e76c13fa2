// The common inputs of all observations.
#pragma once

#include "policy/observation.h"

namespace obby::bench {

// Fills `inputs` (kInputs). The inputs of the maps are set to kEmptyInput. Returns the direction of
// the frame.
Turns observeAllButMaps(const policy::Scene& scene, const sim::World& world,
                        const sim::RigidBody* bodies, float* inputs);

// Returns the solid relative to `origin` in orthonormal `axes`.
policy::Solid along(const Mat3& axes, Vec3 origin, policy::Solid solid);

}  // namespace obby::bench
