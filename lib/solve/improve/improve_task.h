// The goal and the budget of an improvement, and its result.
#pragma once

#include <functional>

#include "solve/improve/preference.h"
#include "solve/model/problem.h"
#include "solve/model/trajectory.h"

namespace obby::solve {

// Simulated ticks that count as a second of improvement. A step budget gives the same answer on
// every machine, which a time limit does not.
constexpr double kImproveStepsPerSecond = 4.5e6;

// All that it refers to must outlive the task.
struct ImproveTask {
  const Problem& problem;
  const Preference& preference;
  uint64_t steps = 0;  // budget, simulated ticks
  uint64_t seed = 1;
  // Returns true if the trajectory is really a solution, and one that may replace the given one.
  std::function<bool(const Trajectory&)> accept;
  std::function<bool()> stop;  // returns true to end early; may be empty
};

struct Improved {
  Trajectory trajectory;
  double cost = 0;     // seconds, by the preference
  uint64_t steps = 0;  // simulated ticks
};

}  // namespace obby::solve
