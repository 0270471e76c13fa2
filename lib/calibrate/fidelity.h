// Measures how closely the simulator reproduces a recording from its inputs alone. Nothing is
// fitted. After the first frame only the recording's inputs and frame lengths are used.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "calibrate/mass_centre.h"
#include "calibrate/objective.h"

namespace obby::calibrate {

// A recording compared with the simulator, frame by frame.
struct Fidelity {
  uint32_t frames = 0;         // frames compared: all but the first
  double mean = 0, max = 0;    // distance between the recorded and simulated root centres, studs
  uint32_t events = 0;         // changes of the recorded state
  uint32_t matched = 0;        // events that the simulator has too, at most one frame apart
  std::optional<double> apex;  // error of the apex height, studs; absent if the recording is
                               // highest at one of its ends
};

// Plays a recording in its level. `params` apply except where the level defines its own. Each
// recorded frame is played as one tick with its own number of physics steps, as the engine does. If
// a part moves, or a frame does not last 1 to 16 whole steps, ticks have the level's length
// instead, and positions are interpolated between two ticks. `tricks`: Params::tricks; `centre`:
// the avatar's centre of mass. Errors: those of Level::compile.
Result<Fidelity> fidelityOf(const Take& take, schema::PhysicsParams::Reader params,
                            uint16_t tricks = 0, const MassCentre& centre = {});

// Statistics over the compared recordings.
struct FidelitySummary {
  double medianMean = 0, p95Mean = 0;  // over the recordings' mean distances, studs
  std::optional<double> matched;       // share of all events; absent without events
  std::optional<double> medianApex;    // studs; absent if no recording has an apex
};

// `all` must not be empty.
FidelitySummary summaryOf(std::span<const Fidelity> all);

}  // namespace obby::calibrate
