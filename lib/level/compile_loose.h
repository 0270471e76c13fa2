// Loose parts of a record: which they are, and the bodies that they make.
#pragma once

#include <vector>

#include "base/result.h"
#include "level/level_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Physics moves it: nothing holds it, and something can push it.
bool isLoose(schema::Part::Reader part);

// The body of a part at `at` whose colliders are those from `first` on, at least one. Errors have
// the path relative to the part.
Result<Loose> looseFrom(schema::Part::Reader part, Vec3 at, const std::vector<Collider>& colliders,
                        size_t first);

}  // namespace obby::level
