// Parameters that decide when something happens, such as from how high a floor is sensed. Errors
// leap by these, and do not change between two leaps; and before it leaps, other parameters bend to
// make up for what happens a tick too late. So values all over the bounds are tried.
#pragma once

#include "calibrate/objective.h"
#include "calibrate/profile.h"
#include "calibrate/work.h"

namespace obby::calibrate {

struct Crossing {
  Profile profile;           // with the other parameters refined at each value
  std::vector<double> best;  // the whole point
  double loss = 0;           // there
};

// `shares`: the values that are tried, ascending. `rounds`: of Gauss-Newton at each, at most.
// `point` stays the best where none is better. The coordinate behind the parameters' is the delay:
// errors hardly have a slope by it within a tick, so that it may be refined with the others. After
// a stop the best is that of the values that were refined before, and the profile of no use.
Crossing crossingOf(const Objective& objective, const std::vector<double>& point, size_t coordinate,
                    const std::vector<double>& shares, int rounds, const Work& work);

// All over the bounds; and finer, up to halfway to the next of those.
std::vector<double> sharesAllOver();
std::vector<double> sharesAround(double share);

// Delays one and two ticks beside that: a wrong one is made up for by accelerations and jumps, and
// shows only once these are refined with it.
std::vector<double> delaysAround(const Objective& objective, double share);

}  // namespace obby::calibrate
