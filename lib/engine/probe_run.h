// One probe: a player comes to a part, stays for a moment and leaves again. Private to lib/engine.
#pragma once

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

struct Manner {
  float share = 0;         // see Stage::standAt
  int face = 0;            // the same
  bool patient = false;    // stays for seconds and touches the part again and again
  bool comesBack = false;  // dies in the end if nothing has happened, to see where it comes back
};

// The number of frames nearest to `seconds`.
uint32_t framesOf(double seconds);

// Runs the probe in this copy of the place, from now on. A player that is harmed and lives touches
// the part in each frame until it is harmed again.
Probe runProbe(Stage& stage, const Plan& plan, Probe probe, Manner manner = {});

}  // namespace obby::engine
