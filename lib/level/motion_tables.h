// Moving parts: a Motion record becomes tables of poses, one row a tick, shared by all worlds.
//
// Keys and spin have tables of their own, so that periods without a common multiple cost their sum
// and not their product. A period that is no whole number of ticks is stored as several
// repetitions, as many as make the error below 1/500 tick where that fits the rows that a table
// may have.
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

// Ticks of the longest motion: 20 minutes, at low rates kMaxRows.
inline double mostTicks(const Params& p) {
  return std::max(double(kMaxRows), 1200.0 * p.controlRate);
}

std::string longerThanMost(const Params& params);  // for errors: "longer than 20 minutes"

// A key of a motion record, checked.
struct MotionKey {
  double time;  // seconds
  Vec3 position;
  Quat rotation;
  schema::Easing easing;
  schema::EasingDirection direction;
};

// A turn about an axis: equal ones make equal tables.
struct SpinPlan {
  Vec3 axis{0, 1, 0};  // unit, in the part's frame
  double speed = 0;    // rad/s
  double offset = 0;   // seconds that have gone at the first row
  uint32_t rows = 0;   // of its table; 0: it does not turn
  double turns = 1;    // in all rows
};

// A motion that has been checked, before its tables are made: few parts need tables of their own.
struct MotionPlan {
  std::vector<MotionKey> keys;  // empty: the part stays at its pose
  bool once = false, pingPong = false;
  double offset = 0;         // seconds that have gone at the first row
  double seconds = 0;        // of a round through the keys
  double secondsPerRow = 0;  // of the table of keys
  uint32_t rows = 0;         // of the table of keys; 0: one, the last key
  uint32_t period = 0;       // ticks of one repetition; all rows where it comes but once
  SpinPlan spin;
  Vec3 pivot;  // of the spin: studs from the part's centre, in the part's frame
};

// Tables have at most `mostRows` rows, or one repetition. Errors have the path relative to the part
// ("motion.keys[2].time").
Result<MotionPlan> planMotion(schema::Motion::Reader motion, const Params& params,
                              uint32_t mostRows = kMaxRows);

// The poses of the keys; `rest` is the part's own. At least one row.
std::vector<Pose> keyTable(const MotionPlan& plan, const Pose& rest);

// The turns of a spin; no rows where it does not turn.
std::vector<Mat3> spinTable(const SpinPlan& plan);

// Progress 0..1 through a tween at linear progress t, as TweenService eases. May leave 0..1 (back,
// elastic).
double ease(schema::Easing easing, schema::EasingDirection direction, double t);

}  // namespace obby::level
