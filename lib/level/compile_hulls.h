// The convex hulls of a part's record.
#pragma once

#include <vector>

#include "base/result.h"
#include "level/hull_tables.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns the hulls that a player can meet; `store` owns them. Flat hulls are dropped: rounding
// leaves them in unions. If a part has only flat hulls, those that are flat along one axis get the
// engine's minimum thickness. Errors have the path relative to the part.
Result<std::vector<const geom::Hull*>> hullsOf(schema::Part::Reader part, HullStore& store);

}  // namespace obby::level
