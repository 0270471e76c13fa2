// Checks an answer as the player of its trajectory.
#pragma once

#include "base/result.h"
#include "solve/query_solver.h"

namespace obby::solve {

// Calls verify() in the player's level. A slowest player's solution of a query for the same keys
// must also solve the query for every other player that it names.
Status verifyPlayer(const LoadedLevel& level, schema::Query::Reader query,
                    schema::Trajectory::Reader trajectory);

}  // namespace obby::solve
