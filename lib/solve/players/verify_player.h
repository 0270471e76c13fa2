// Checks a trajectory in the level of its player.
#pragma once

#include "base/result.h"
#include "solve/answer/solver_options.h"

namespace obby::solve {

// Calls verify() in the player's level. If the query asks for the same keys, a solution of the
// slowest player must also solve it for every other player.
Status verifyPlayer(const LoadedLevel& level, schema::Query::Reader query,
                    schema::Trajectory::Reader trajectory);

}  // namespace obby::solve
