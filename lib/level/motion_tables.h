// Moving parts: a Motion record becomes tables of poses, one row a tick, shared by all worlds.
//
// Keys and spin have tables of their own, so that periods without a common multiple cost their sum
// and not their product. A period that is no whole number of ticks is stored as several
// repetitions, as many as make the error below 1/500 tick where that fits
// kMaxRows.
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

struct MotionTables {
  std::vector<Pose> keys;   // at least one
  std::vector<Mat3> spins;  // may be empty
  Vec3 pivot;
  bool once = false;
  uint32_t period = 0;  // ticks of one repetition; all rows where it comes but once
};

// `rest` is the part's own pose. Errors have the path relative to the part ("motion.keys[2].time").
Result<MotionTables> motionTables(schema::Motion::Reader motion, const Pose& rest,
                                  const Params& params);

// Progress 0..1 through a tween at linear progress t, as TweenService eases. May leave 0..1 (back,
// elastic).
double ease(schema::Easing easing, schema::EasingDirection direction, double t);

}  // namespace obby::level
