// Size and surface of a part in a record, with their limits.
#pragma once

#include "base/result.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Smallest extent that the engine's physics uses (docs/parts.md, shapes).
constexpr float kMinSize = 0.05f;
constexpr float kMaxSize = 2048;
constexpr float kMaxFriction = 100, kMaxFrictionWeight = 100;

// Half of the size; extents below kMinSize count as kMinSize.
Result<Vec3> halfExtents(schema::Part::Reader part);

// An error if friction or elasticity is out of range.
Status checkSurface(schema::Part::Reader part);

}  // namespace obby::level
