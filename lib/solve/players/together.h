// Searches for keys that solve a query for all of its players.
#pragma once

#include "solve/players/players_run.h"

namespace obby::solve {

// Answers all cases together: the slowest player searches, and each state must also hold for the
// others.
Status solveTogether(PlayersRun& run);

// Looks for keys that work for all players, after each of them has its own solution. Tries the keys
// of these solutions first, then searches within the budget for improvement. If it finds some, they
// replace the solutions, and it returns true.
Result<bool> shareKeys(PlayersRun& run);

}  // namespace obby::solve
