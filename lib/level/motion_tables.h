// Compiles a Motion record to tables of poses, one row per tick, shared by all worlds.
//
// Keys and spin have separate tables, so that periods without a common multiple cost their sum and
// not their product. A period that is not a whole number of ticks is stored as several repetitions.
// Their number makes the error smaller than 1/500 tick, if a table may have that many rows.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/params.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::level {

constexpr uint32_t kMaxRows = 36000 * 2;  // 10 minutes of ping-pong at 60 ticks/s

// Returns the ticks of the longest motion: 20 minutes, or kMaxRows at low rates.
inline double maxTicks(const Params& p) {
  return std::max(double(kMaxRows), 1200.0 * p.controlRate);
}

std::string longerThanMax(const Params& params);  // as in "longer than the allowed 20 minutes"

// A checked key of a motion record.
struct MotionKey {
  double time;  // seconds
  Vec3 position;
  Quat rotation;
  schema::Easing easing;
  schema::EasingDirection direction;
};

// A rotation about an axis. Equal plans make equal tables.
struct SpinPlan {
  Vec3 axis{0, 1, 0};  // unit, in the part's frame
  double speed = 0;    // rad/s
  double offset = 0;   // seconds elapsed at the first row
  uint32_t rows = 0;   // rows of its table; 0 if it does not turn
  double turns = 1;    // turns in all rows together
};

// A checked motion before its tables are made. Few parts need their own tables.
struct MotionPlan {
  std::vector<MotionKey> keys;  // empty: the part stays at its pose
  bool once = false, pingPong = false;
  double offset = 0;         // seconds elapsed at the first row
  double seconds = 0;        // duration of one round through the keys
  double secondsPerRow = 0;  // seconds between rows of the table of keys
  uint32_t rows = 0;         // rows of the table of keys; 0 for a single row with the last key
  uint32_t period = 0;       // ticks of one repetition; all rows if it runs once
  SpinPlan spin;
  Vec3 pivot;  // pivot of the spin, studs from the part's centre, in its frame
};

// Checks a motion and plans its tables. They have at most `maxRows` rows, or as many as one
// repetition needs. Errors have the path relative to the part ("motion.keys[2].time").
Result<MotionPlan> planMotion(schema::Motion::Reader motion, const Params& params,
                              uint32_t maxRows = kMaxRows);

// Returns the poses of the keys, at least one row. `rest` is the part's own pose.
std::vector<Pose> keyTable(const MotionPlan& plan, const Pose& rest);

// Returns the turns of a spin, or no rows if it does not turn.
std::vector<Mat3> spinTable(const SpinPlan& plan);

// Returns the progress of a tween at linear progress t, as TweenService eases it. The result may be
// outside 0..1 (back, elastic).
double ease(schema::Easing easing, schema::EasingDirection direction, double t);

}  // namespace obby::level
