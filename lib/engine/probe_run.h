// One probe: a player comes to a part, stays for a moment and leaves again. Private to lib/engine.
#pragma once

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

struct Manner {
  float share = 0;       // see Stage::standAt
  int face = 0;          // the same
  bool patient = false;  // stays for seconds and touches the part again and again
  // Is watched until it lives again if it dies with progress, and dies if nothing has happened.
  bool comesBack = false;
};

// The number of frames nearest to `seconds`.
uint32_t framesOf(double seconds);

// Runs the probe in this copy of the place, from now on. A player that is harmed and lives touches
// the part in each frame until it is harmed again.
Probe runProbe(Stage& stage, const Plan& plan, Probe probe, Manner manner = {});

}  // namespace obby::engine
