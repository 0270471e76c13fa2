// Dynamic parts of a record: the test for them, and the bodies that they make.
#pragma once

#include <vector>

#include "base/result.h"
#include "level/level_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns true if physics moves the part: it is solid, not anchored, and has no motion and no fall.
bool isDynamic(schema::Part::Reader part);

// Returns the body of a part at `at`. Its colliders are those from `first` on, at least one. Errors
// have the path relative to the part.
Result<DynamicBody> bodyFrom(schema::Part::Reader part, Vec3 at,
                             const std::vector<Collider>& colliders, size_t first);

}  // namespace obby::level
