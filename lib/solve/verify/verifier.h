// Checks an answer without the search: replays the trajectory record through the scalar simulator
// and judges it against the query record in its own double-precision code. A solution is reported
// only if this agrees.
#pragma once

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"

namespace obby::solve {

// Success: the playthrough starts where, when and facing as the query says, ends as the record
// says, at the tick, with the jumps, waypoints and state hash that the record says, and is where
// its endPosition and path say, if it has them. The Error's path names the first field of the
// trajectory that is wrong, its message what the replay gave. Level and query must be such as
// compile.
Status verify(const level::Level& level, schema::Level::Reader levelRecord,
              schema::Query::Reader query, schema::Trajectory::Reader trajectory);

}  // namespace obby::solve
