// Checks an answer as the player whose trajectory it is.
#pragma once

#include "base/result.h"
#include "solve/solver_options.h"

namespace obby::solve {

// As verify() in the player's level. A solution of a query for the same keys must also solve it for
// every other player that the query names, with the keys of its slowest player.
Status verifyPlayer(const LoadedLevel& level, schema::Query::Reader query,
                    schema::Trajectory::Reader trajectory);

}  // namespace obby::solve
