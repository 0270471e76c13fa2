// A recording's inputs, played by the simulator under given parameters, from any of its frames on.
#pragma once

#include <functional>
#include <vector>

#include "calibrate/track.h"
#include "level/level.h"
#include "sim/simulator.h"

namespace obby::calibrate {

// Frames first ... last of a track: the simulator starts as the first one is, and is held against
// the others.
struct Window {
  uint32_t first, last;
};

// Side by side, of about so many seconds each; with loose bodies in the level that the track does
// not show, one from the start to the end.
std::vector<Window> windowsOf(const Track& track, double seconds, const level::LevelView& level);

// The state that a frame shows, as far as it shows it.
sim::World worldAt(const Track& track, uint32_t frame, const level::LevelView& level);

// The simulator's player at the time of a frame, between the two nearest ticks.
struct Moment {
  Vec3 position;  // of the root part's centre
  Vec3 velocity;
  Vec3 facing;                             // level, about unit
  sim::State state = sim::State::running;  // after the later of the two ticks
};

// `delay`: seconds from an input to what comes of it. Calls visit(window, frame, moment) for every
// frame but the first of each window, frames ascending within a window.
using Visit = std::function<void(uint32_t window, uint32_t frame, const Moment& moment)>;
void playBack(const level::LevelView& level, const Track& track, const std::vector<Window>& windows,
              double delay, const Visit& visit);

}  // namespace obby::calibrate
