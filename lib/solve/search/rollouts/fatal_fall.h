// Finds the height below which a player can only fall, so that a search need not go on.
#pragma once

#include "solve/model/problem.h"

namespace obby::solve {

// Returns the height, in studs. A player whose feet are lower, and off any floor for longer than
// the coyote time, meets no part or region any more. Returns -1e30 if the level has dynamic parts,
// which may fall, too.
float fatalHeight(const Problem& problem);

}  // namespace obby::solve
