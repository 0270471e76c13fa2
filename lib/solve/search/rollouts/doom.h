// Where nothing but falling is left of a playthrough: a search need not go on there.
#pragma once

#include "solve/model/problem.h"

namespace obby::solve {

// Feet lower than this, off any floor for longer than the coyote time, meet no part and no region
// any more. -1e30 where loose parts may fall along.
float doomHeight(const Problem& problem);

}  // namespace obby::solve
