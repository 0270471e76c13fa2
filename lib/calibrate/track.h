// A recording in plain form: what a player of the real engine did, and where it took them.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "level/params.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"
#include "sim/world.h"

namespace obby::calibrate {

// A sample. Its input is in force from here to the next one.
struct Frame {
  double time = 0;  // seconds since the first frame
  Vec3 move;        // move direction, world axes, length 0 to 1
  bool jump = false;
  Vec3 position;  // of the root part's centre, studs
  Vec3 velocity;  // studs/s
  sim::State state = sim::State::freefall;
};

struct Track {
  std::string name, level;
  std::vector<Frame> frames;  // at least two, times ascending
};

// Frames that the recorder wrote twice are left out. Errors: fewer than two frames, a time that
// goes back, what is not finite.
Result<Track> trackOf(schema::Recording::Reader record);

// Of an engine's name for it; whoever is in none that a course needs is taken by how they move.
sim::State stateOf(const std::string& name, Vec3 velocity);

// The root part's centre above the feet, and back.
Vec3 rootOf(Vec3 feet, const Params& params);
Vec3 feetOf(const Frame& frame, const Params& params);

// What is held at `frame`: below a tenth of the full stick nothing.
sim::Action actionOf(const Frame& frame);

}  // namespace obby::calibrate
