// Recorded frames played as ticks of their own numbers of physics steps, as the engine does it.
#pragma once

#include <vector>

#include "calibrate/mass_centre.h"
#include "level/level.h"

namespace obby::calibrate {

constexpr uint32_t kMaxSteps = 16;  // of a tick

// Physics steps between two frames; 0: no whole number of them.
uint32_t stepsBetween(const Frame& a, const Frame& b, double stepsPerSecond);

// Physics steps of each frame but the last; empty: a frame is no whole number of them, or too long.
// A frame on the floor whose place and speed fit only another number than its time has that one:
// the clock of a recording is that of the rendering, not of the physics.
std::vector<uint32_t> stepsOf(const Track& track, double stepsPerSecond);

// The frames' own times, in physics steps. Times of a recording are whole steps, but the engine
// counts some clocks by the time of its frames. Where the frames around come as steadily as a
// display's, that is their mean; elsewhere what the recording says.
std::vector<float> ownSteps(const std::vector<uint32_t>& steps);

struct Played {
  Vec3 position;  // of the root's centre
  sim::State state;
};

// (frames), the first as recorded. `view`: with ticks as long as the longest frame at least.
std::vector<Played> playFrames(level::LevelView view, const Track& track,
                               const std::vector<uint32_t>& steps, const MassCentre& centre);

}  // namespace obby::calibrate
