// Search over times that the simulator counts in whole ticks: tries each count within the bounds.
#pragma once

#include "calibrate/objective.h"
#include "calibrate/profile.h"
#include "calibrate/work.h"

namespace obby::calibrate {

// Results for all tick-valued times whose bounds allow a whole number of ticks.
struct Scan {
  std::vector<Profile> profiles;  // each minimised over the other counts
  std::vector<double> best;       // point with the counts of the lowest loss; ties go to the counts
                                  // nearest to the fit's start
  bool better = false;            // true if that loss is less than the point's
  size_t frames = 0;  // frames of the recordings in which one of the times has an effect
};

// Two times can hide each other: a jump after an edge is possible only while both are unexpired. So
// counts can be tried in pairs, which takes longer. Beyond a limit on counts, pairs are skipped.
enum class Tried { singly, inPairs };

// Searches the counts; the other coordinates keep their values. After a stop, all coordinates keep
// their values, and the profiles are meaningless.
Scan scanOf(const Objective& objective, const std::vector<double>& point, Tried tried,
            const Work& work);

// Returns the counts of one time up to two ticks away from the point's.
std::vector<double> countsAround(const Objective& objective, const std::vector<double>& point,
                                 size_t coordinate);

// Moves to the best counts and the best delay in quarters of a tick, while the loss falls. An input
// counts for a whole tick or not at all, so the delay may have no gradient either. Returns true if
// the loss fell.
bool settle(const Objective& objective, std::vector<double>& point, Tried tried, const Work& work);

}  // namespace obby::calibrate
