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
  Vec3 facing = {};  // level look vector of the root part, unit; all 0: not recorded
};

// Where a part is.
struct PartPose {
  Vec3 position;  // of its centre, studs
  Quat rotation;
};

struct Track {
  std::string name, level;
  std::vector<Frame> frames = {};       // at least two, times ascending
  std::vector<std::string> shown = {};  // parts whose poses are recorded
  std::vector<PartPose> poses = {};     // (frames, shown)
  std::vector<uint32_t> parts = {};     // of `shown`, in the level (surroundings.h)
  double phase = 0;                     // level clock at the first frame, seconds (surroundings.h)

  // Without a frame, as a recorder that was too late leaves it.
  void drop(size_t frame);

  const PartPose& pose(size_t frame, size_t part) const {
    return poses[frame * shown.size() + part];
  }
  // The level clock at a time of the track, in ticks of the level that is played.
  uint32_t tickAt(double time, const Params& params) const;
};

// To the nearest; of a negative time none.
uint32_t wholeTicks(double seconds, const Params& params);

// Times count from the first frame on, whatever clock they are of. Of frames of one time the first
// stays, with the input and the poses of the last. Errors: fewer than two frames, a time that goes
// back or leaps ahead, what is not finite or far beyond any game, poses of other parts than the
// recording names.
Result<Track> trackOf(schema::Recording::Reader record);

// Of an engine's name for it; whoever is in none that a course needs is taken by how they move.
sim::State stateOf(const std::string& name, Vec3 velocity);
const char* nameOf(sim::State state);  // the engine's

// The root part's centre above the feet, and back.
Vec3 rootOf(Vec3 feet, const Params& params);
Vec3 feetOf(const Frame& frame, const Params& params);

// What is held at `frame`: below a tenth of the full stick nothing.
sim::Action actionOf(const Frame& frame);

}  // namespace obby::calibrate
