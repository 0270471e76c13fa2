// Plays recorded frames as ticks with their own numbers of physics steps, as the engine does.
#pragma once

#include <vector>

#include "calibrate/mass_centre.h"
#include "level/level.h"

namespace obby::calibrate {

constexpr uint32_t kMaxSteps = 16;  // max of a tick

// Returns the physics steps between two frames, or 0 if their number is not whole.
uint32_t stepsBetween(const Frame& a, const Frame& b, double stepsPerSecond);

// Returns the physics steps of each frame but the last. Empty if a frame is not a whole number of
// steps, or too long. A frame on the floor gets the number that fits its motion if the one of its
// time does not, because recordings use the clock of the renderer and not of the physics.
std::vector<uint32_t> stepsOf(const Track& track, double stepsPerSecond);

// Returns each frame's own time in physics steps. Recorded times are whole steps, but the engine
// counts some clocks by frame time. Within a steady frame rate it is the mean of the frames around,
// elsewhere the recorded time.
std::vector<float> ownSteps(const std::vector<uint32_t>& steps);

struct Played {
  Vec3 position;  // of the root's centre
  sim::State state;
};

// Returns (frames), the first as recorded. The ticks of `view` must cover the longest frame.
std::vector<Played> playFrames(level::LevelView view, const Track& track,
                               const std::vector<uint32_t>& steps, const MassCentre& centre);

}  // namespace obby::calibrate
