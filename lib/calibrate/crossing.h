// Parameters that decide when an event happens, such as the height from which a floor is sensed.
// The error is piecewise constant in them, so they have no gradient. Near a discontinuity the other
// parameters compensate for an event that happens one tick late. So values across the whole range
// are tried.
#pragma once

#include "calibrate/objective.h"
#include "calibrate/profile.h"
#include "calibrate/work.h"

namespace obby::calibrate {

struct Crossing {
  Profile profile;           // losses with the other parameters refined
  std::vector<double> best;  // point with the lowest loss
  double loss = 0;           // loss at `best`
};

// Tries `shares` (ascending) for one coordinate, and refines the others at each in up to `rounds`
// rounds of Gauss-Newton. `best` is `point` if no value is better. The coordinate after the
// parameters is the delay. Within a tick it has almost no gradient, so it may be refined with the
// others. After a stop, `best` covers the values refined until then and the profile is meaningless.
Crossing crossingOf(const Objective& objective, const std::vector<double>& point, size_t coordinate,
                    const std::vector<double>& shares, int rounds, const Work& work);

// sharesAllOver() returns values over the whole range. sharesAround() returns finer ones around
// `share`, up to halfway to the next of those values.
std::vector<double> sharesAllOver();
std::vector<double> sharesAround(double share);

// Returns the delays one and two ticks away. Accelerations and jumps compensate for a wrong delay,
// which shows only after they are refined with it.
std::vector<double> delaysAround(const Objective& objective, double share);

}  // namespace obby::calibrate
