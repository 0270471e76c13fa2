// How often the player may jump again before it lands. Private to lib/engine.
#pragma once

#include <cstdint>

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// In this copy of the place: the player takes off, falls, and presses jump again and again; then it
// lands and does so once more. Only what works in both flights counts.
AirJumps findAirJumps(Stage& stage);

}  // namespace obby::engine
