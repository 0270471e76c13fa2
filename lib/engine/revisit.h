// Probes once more after other parts have been touched: traps that a lever arms, doors that need
// two buttons, what works only once. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// The place is as it was at the first probes. Only what differs from them is returned.
std::vector<Revisit> revisit(Stage& stage, const Plan& plan, const std::vector<Probe>& first);

}  // namespace obby::engine
