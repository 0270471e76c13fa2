// Finds how often the player may jump again before it lands. Private to lib/engine.
#pragma once

#include <cstdint>

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// Tests jumps in this copy of the place. The player takes off, falls, and presses jump again and
// again; then it lands and repeats this once. Only effects that occur in both flights count.
AirJumps findAirJumps(Stage& stage);

}  // namespace obby::engine
