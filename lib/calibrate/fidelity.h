// How near the simulator comes to a recording by its inputs alone: nothing is fitted, and nothing
// of the recording but its inputs and the lengths of its frames is used after the first frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "calibrate/mass_centre.h"
#include "calibrate/objective.h"

namespace obby::calibrate {

// A recording compared with the simulator, frame by frame.
struct Fidelity {
  uint32_t frames = 0;         // compared: all but the first
  double mean = 0, max = 0;    // distance between the root's centres, studs
  uint32_t events = 0;         // changes of the recorded state
  uint32_t matched = 0;        // of these, made by the simulator at most one frame away
  std::optional<double> apex;  // error of the highest point's height, studs; absent: the recording
                               // is highest at one of its ends
};

// Plays a recording in its level, under `params` but for what the level states itself. A recorded
// frame is played as one tick of its own number of physics steps, as the engine does it. Where a
// part moves or a frame is not 1 to 16 whole steps, ticks last as the level says, and positions
// between two ticks are interpolated. `tricks`: Params::tricks; `centre`: the avatar's. Errors:
// those of Level::compile.
Result<Fidelity> fidelityOf(const Take& take, schema::PhysicsParams::Reader params,
                            uint16_t tricks = 0, const MassCentre& centre = {});

// Over the recordings that were compared.
struct FidelitySummary {
  double medianMean = 0, p95Mean = 0;  // of the recordings' mean distances, studs
  std::optional<double> matched;       // share of all events; absent: there are none
  std::optional<double> medianApex;    // studs; absent: no recording has an apex
};

// `all`: at least one.
FidelitySummary summaryOf(std::span<const Fidelity> all);

}  // namespace obby::calibrate
