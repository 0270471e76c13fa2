// The highest speeds that a level's parts can give a player, and so how far a tick carries one.
#pragma once

#include "level/compile_parts.h"

namespace obby::level {

// Sideways, studs/s: walking, and on top of it what the fastest part gives.
float fastestSideways(const PartTables& tables, const Params& params);

// Launch speed of a jump, studs/s.
float fastestJump(const PartTables& tables, const Params& params);

}  // namespace obby::level
