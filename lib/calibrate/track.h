// A recording in plain form: a player's inputs in the real engine and the resulting trajectory.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "level/params.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"
#include "sim/world.h"

namespace obby::calibrate {

// A sample. Its input is active until the next sample.
struct Frame {
  double time = 0;  // seconds since the first frame
  Vec3 move;        // move direction, world axes, length 0 to 1
  bool jump = false;
  Vec3 position;  // centre of the root part, studs
  Vec3 velocity;  // studs/s
  sim::State state = sim::State::freefall;
  Vec3 facing = {};  // horizontal look vector of the root part, unit; all 0 if not recorded
};

// A part's pose.
struct PartPose {
  Vec3 position;  // the part's centre, studs
  Quat rotation;
};

struct Track {
  std::string name, level;
  std::vector<Frame> frames = {};       // at least two, times ascending
  std::vector<std::string> shown = {};  // parts whose poses are recorded
  std::vector<PartPose> poses = {};     // (frames, shown)
  std::vector<uint32_t> parts = {};     // level index of each in `shown` (surroundings.h)
  double phase = 0;                     // level clock at the first frame, seconds (surroundings.h)

  // Removes a frame, as if the recorder had missed it.
  void drop(size_t frame);

  const PartPose& pose(size_t frame, size_t part) const {
    return poses[frame * shown.size() + part];
  }
  // Returns the level clock at a time of the track, in ticks of the level.
  uint32_t tickAt(double time, const Params& params) const;
};

// Rounds to the nearest tick. Returns 0 for a negative time.
uint32_t wholeTicks(double seconds, const Params& params);

// Converts a recording. Times count from the first frame. If several frames have the same time, the
// first stays, with the last one's input and poses. Errors: fewer than two frames, a time that
// decreases or jumps ahead, values that are not finite or out of range, and a wrong number of
// poses.
Result<Track> trackOf(schema::Recording::Reader record);

// Returns the state with the engine's name `name`. Unknown names are classified by the velocity.
sim::State stateOf(const std::string& name, Vec3 velocity);
const char* nameOf(sim::State state);  // the engine's name

// Convert between the feet and the root part's centre.
Vec3 rootOf(Vec3 feet, const Params& params);
Vec3 feetOf(const Frame& frame, const Params& params);

// Returns the action of a frame. A stick below a tenth of its range counts as released.
sim::Action actionOf(const Frame& frame);

}  // namespace obby::calibrate
