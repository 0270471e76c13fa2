// Probes of players that fall onto parts. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/child.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// If scripts read how the player moves, tests whether a part acts differently on a falling player.
// Sets `byFall` of `probes`. `wanted` holds the requests that led to these probes.
void lookAtFalls(Stage& stage, const Plan& plan, Children& children,
                 const std::vector<Probe>& wanted, std::vector<Probe>& probes);

}  // namespace obby::engine
