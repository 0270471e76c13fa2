// Probes of players who fall onto parts. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/child.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// Where scripts read how the player moves, looks whether a part does something else to a player who
// falls on it: sets `byFall`. `wanted`: what the probes were.
void lookAtFalls(Stage& stage, const Plan& plan, Children& children,
                 const std::vector<Probe>& wanted, std::vector<Probe>& probes);

}  // namespace obby::engine
