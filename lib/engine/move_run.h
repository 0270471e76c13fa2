// The player's moves away from all parts, where scripts look at them. Private to lib/engine.
#pragma once

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

struct Move {
  Probe probe;
  std::vector<Probe> targets;  // what a probe may go to, by then
};

// Walks, jumps, falls or exerts itself in this copy of the place, from now on. `again`: does so
// once before.
Move runMove(Stage& stage, Approach approach, bool again);

}  // namespace obby::engine
