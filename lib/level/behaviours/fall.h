// The motion of a falling part, which its own clock drives.
#pragma once

#include <vector>

#include "level/params.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Returns the poses from the touch on, one per tick, at least two rows. The part stays at the last
// pose.
std::vector<Pose> fallTable(schema::Fall::Reader fall, const Pose& rest, const Params& params);

}  // namespace obby::level
