// Makes a solution better by a preference: cuts corners, drops and shifts jumps, simplifies keys,
// and searches again under tighter limits. Every change is played in the simulator.
#pragma once

#include <functional>

#include "solve/improve/preference.h"
#include "solve/search/method.h"

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

// Changes the solution until the budget is spent. Never returns a dearer one.
Improved improve(const ImproveTask& task, const Trajectory& solution);

// Does the same, and also lets `method` search for solutions, or for parts of one, with fewer jumps
// or in less time.
Improved improveWidely(const ImproveTask& task, const Trajectory& solution, const Method& method,
                       const Machine& machine);

}  // namespace obby::solve
