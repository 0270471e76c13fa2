// The convex hulls of a part's record.
#pragma once

#include <vector>

#include "base/result.h"
#include "level/hull_tables.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Those that a player can meet; `store` owns them. Flat ones are left out, as rounding leaves them
// of unions. Where a part has no others, those that are flat along an axis are as thick as the
// engine makes thin parts. Errors have the path relative to the part.
Result<std::vector<const geom::Hull*>> hullsOf(schema::Part::Reader part, HullStore& store);

}  // namespace obby::level
