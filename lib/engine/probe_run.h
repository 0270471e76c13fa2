// One probe: a player comes to a part, stays for a moment and leaves. Private to lib/engine.
#pragma once

#include <optional>

#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

enum class Stay : uint8_t {
  renewing,  // touches the part in each frame after it is harmed, until harmed again
  still,     // waits until it is harmed again
  brief      // leaves when it is harmed
};

struct Manner {
  Stay stay = Stay::renewing;
  float share = 0;       // see Stage::standAt
  int face = 0;          // see Stage::standAt
  bool falls = false;    // arrives at the speed of a fall
  bool patient = false;  // stays for seconds and touches the part repeatedly
  // Watches a player that dies with progress until it lives again. If nothing happened, kills it.
  bool comesBack = false;
};

// Max share of the whole time limit for one copy of the place. A copy that hangs must leave time
// for the others.
constexpr double kCopyShare = 0.25;

// Returns the number of frames nearest to `seconds`.
uint32_t framesOf(double seconds);

// Runs the probe in this copy of the place.
Probe runProbe(Stage& stage, const Plan& plan, Probe probe, Manner manner = {});

// Returns how to probe a harmful part again. Repeated harm gets a brief stay, since one touch may
// have begun it. A single harm gets a still stay, since more touches may have prevented a second.
std::optional<Stay> secondLookAt(const Probe& probe);
// Runs the probe again, in another copy of the place.
SecondLook lookAgain(Stage& stage, const Plan& plan, const Probe& wanted, Stay stay);
// Returns the member of `probe` that keeps the result.
SecondLook& secondLookOf(Probe& probe, Stay stay);

}  // namespace obby::engine
