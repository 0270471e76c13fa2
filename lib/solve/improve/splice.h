// Puts the best spans of several solutions together.
#pragma once

#include "base/random.h"
#include "solve/improve/variation_pool.h"

namespace obby::solve {

// Draws a span of a donor that begins and ends where the line's player also stands, and that costs
// less than the line does in between. Puts it into the variation. Returns false, and leaves the
// variation unchanged, if no such span was drawn.
bool splice(const Line& line, const GuidedLines& donors, Variation& variation, Random& random);

}  // namespace obby::solve
