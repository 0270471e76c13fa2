// Plays recorded frames as ticks with their own numbers of physics steps, as the engine does.
#pragma once

#include <vector>

#include "calibrate/mass_centre.h"
#include "calibrate/track.h"
#include "level/level.h"
#include "sim/world.h"

namespace obby::calibrate {

constexpr uint32_t kMaxSteps = 16;  // max steps of a tick

// Returns the physics steps between two frames, or 0 if their number is not whole.
uint32_t stepsBetween(const Frame& a, const Frame& b, double stepsPerSecond);

// Returns the physics steps of each frame but the last. Returns an empty list if a frame is too
// long or not a whole number of steps. If the time of a frame on the floor does not fit its motion,
// the motion decides, because recordings use the renderer's clock and not that of the physics.
std::vector<uint32_t> stepsOf(const Track& track, double stepsPerSecond);

// Returns each frame's own time in physics steps. Recorded times are whole steps, but the engine
// counts some clocks by frame time. At a steady frame rate this is the mean of the surrounding
// frames; otherwise it is the recorded time.
std::vector<float> ownSteps(const std::vector<uint32_t>& steps);

struct Played {
  Vec3 position;  // centre of the root, studs
  sim::State state;
};

// Returns one entry per frame. The first is as recorded. The ticks of `view` must cover the longest
// frame.
std::vector<Played> playFrames(level::LevelView view, const Track& track,
                               const std::vector<uint32_t>& steps, const MassCentre& centre);

}  // namespace obby::calibrate
