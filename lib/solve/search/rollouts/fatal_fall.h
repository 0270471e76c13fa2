// Finds the height below which a player can only fall, so that a search need not go on.
#pragma once

#include "solve/model/problem.h"

namespace obby::solve {

// Returns a height. Feet that are lower, and off any floor for longer than the coyote time, meet no
// part and no region any more. Returns -1e30 if dynamic parts may fall along.
float fatalHeight(const Problem& problem);

}  // namespace obby::solve
