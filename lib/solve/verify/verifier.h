// Checks an answer without the search. It replays the trajectory record through the scalar
// simulator, and judges it against the query record in its own double-precision code. A solution is
// reported only if this check passes.
#pragma once

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"

namespace obby::solve {

// Succeeds if the trajectory starts as the query says and ends as the record says: the outcome,
// tick, jumps, waypoints and state hash. Its endPosition and path must match the replay, if it has
// them. The error's path names the first wrong field of the trajectory, and its message the
// replayed value. Level and query must be valid.
Status verify(const level::Level& level, schema::Level::Reader levelRecord,
              schema::Query::Reader query, schema::Trajectory::Reader trajectory);

}  // namespace obby::solve
