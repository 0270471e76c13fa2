// Repeats probes after other parts have been touched. This finds traps that a lever arms, doors
// that need two buttons, and effects that work only once. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// Returns only the probes that differ from the first ones. The place must be in the state in which
// the first probes began.
std::vector<Revisit> revisit(Stage& stage, const Plan& plan, const std::vector<Probe>& first);

}  // namespace obby::engine
