// Playback of a recording's inputs in the simulator under given parameters, from any frame on.
#pragma once

#include <functional>
#include <vector>

#include "calibrate/track.h"
#include "level/level.h"
#include "sim/simulator.h"

namespace obby::calibrate {

// Frames `first` to `last` of a track. The simulation starts from the first one and is compared
// with the others.
struct Window {
  uint32_t first, last;
};

// Returns consecutive windows of about `seconds` each. Returns a single window from start to end if
// showsBodies() is false (surroundings.h).
std::vector<Window> windowsOf(const Track& track, double seconds, const level::LevelView& level);

// Returns the state of a frame, as far as it was recorded.
sim::World worldAt(const Track& track, uint32_t frame, const level::LevelView& level);

// The simulated player at a frame's time, interpolated between the two nearest ticks.
struct Moment {
  Vec3 position;  // centre of the root part, studs
  Vec3 velocity;
  Vec3 facing;                             // horizontal, approximately unit length
  sim::State state = sim::State::running;  // state at the nearer of the two ticks
};

using Visit = std::function<void(uint32_t window, uint32_t frame, const Moment& moment)>;
// `delay`: seconds from an input to its effect. Calls visit(window, frame, moment) for every frame
// but the first of each window, in ascending order within a window.
void playBack(const level::LevelView& level, const Track& track, const std::vector<Window>& windows,
              double delay, const Visit& visit);

}  // namespace obby::calibrate
