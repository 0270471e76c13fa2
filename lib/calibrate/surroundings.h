// The surroundings of a recorded player: the level clock at the start, and the poses of dynamic
// bodies.
#pragma once

#include <string>
#include <vector>

#include "calibrate/track.h"
#include "level/level.h"
#include "sim/rigid_body.h"

namespace obby::calibrate {

constexpr uint32_t kLongestClock = 120;  // max level clock that is tried, seconds

// Finds the recorded parts in the level, and the level clock at the first frame. That is the tick
// from which the level's moving parts match the recorded ones best. Errors: a part that is not in
// the level, or more than once.
Status place(Track& track, schema::Level::Reader record, const level::Level& level);

// A moving part that does not follow the level's motion.
struct Stray {
  std::string part;  // name in the recording
  uint32_t number;   // index in the level
  float studs;       // distance, root mean square
};
std::vector<Stray> straysOf(const Track& track, const level::LevelView& level);

// Returns true if each dynamic body is recorded or stays far from the player. Then the simulation
// can start at any frame.
bool showsBodies(const Track& track, const level::LevelView& level);

// Sets the recorded dynamic bodies to a frame's poses and velocities. Returns true if one moves.
bool showBodies(const Track& track, uint32_t frame, const level::LevelView& level,
                std::vector<sim::RigidBody>& bodies);

}  // namespace obby::calibrate
