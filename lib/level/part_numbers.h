// Size and surface of a part in a record, with their limits.
#pragma once

#include "base/result.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// The smallest extent that the engine's physics uses (docs/parts.md, shapes).
constexpr float kMinSize = 0.05f;
constexpr float kMaxSize = 2048;
constexpr float kMaxFriction = 100, kMaxFrictionWeight = 100;

// Returns half of the size. Extents below kMinSize count as kMinSize. Sizes outside (0, kMaxSize]
// are errors.
Result<Vec3> halfExtents(schema::Part::Reader part);

// Returns an error if friction, its weight or elasticity is out of range.
Status checkSurface(schema::Part::Reader part);

}  // namespace obby::level
