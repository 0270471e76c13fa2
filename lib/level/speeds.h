// The max speeds that a level's parts can give a player. They bound the distance that a player
// moves in a tick.
#pragma once

#include "level/compile_parts.h"

namespace obby::level {

// Returns the max sideways speed, studs/s: walking, plus the fastest part.
float fastestSideways(const PartTables& tables, const Params& params);

// Returns the max launch speed of a jump, studs/s.
float fastestJump(const PartTables& tables, const Params& params);

}  // namespace obby::level
