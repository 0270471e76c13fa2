// One probe: a player comes to a part, stays for a moment and leaves again. Private to lib/engine.
#pragma once

#include <optional>

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

enum class Stay : uint8_t {
  renewing,  // a player that is harmed and lives touches the part in each frame until harmed again
  still,     // it waits until it is harmed again
  brief      // it leaves when it is harmed
};

struct Manner {
  Stay stay = Stay::renewing;
  float share = 0;       // see Stage::standAt
  int face = 0;          // the same
  bool falls = false;    // arrives at the speed of a fall
  bool patient = false;  // stays for seconds and touches the part again and again
  // Is watched until it lives again if it dies with progress, and dies if nothing has happened.
  bool comesBack = false;
};

// The number of frames nearest to `seconds`.
uint32_t framesOf(double seconds);

// Runs the probe in this copy of the place, from now on.
Probe runProbe(Stage& stage, const Plan& plan, Probe probe, Manner manner = {});

// How to look again at a part that has harmed: briefly if it did so again and again, which a single
// touch may have begun; still if it did so once, since touches again may have hindered it.
std::optional<Stay> secondLookAt(const Probe& probe);
// Runs the probe again, in another copy of the place.
SecondLook lookAgain(Stage& stage, const Plan& plan, const Probe& wanted, Stay stay);
// Where the probe keeps it.
SecondLook& secondLookOf(Probe& probe, Stay stay);

}  // namespace obby::engine
