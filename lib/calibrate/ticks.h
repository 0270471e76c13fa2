// Times that the simulator counts in whole ticks: each count between their bounds is tried.
#pragma once

#include "calibrate/objective.h"
#include "calibrate/profile.h"
#include "calibrate/work.h"

namespace obby::calibrate {

// Of all such times that can be a whole number of ticks within their bounds.
struct Scan {
  std::vector<Profile> profiles;  // each by the best counts of every other one
  std::vector<double> best;       // the point with the counts of the least loss; of alike ones
                                  // those nearest to where the fit began
  bool better = false;            // that loss is less than the point's
  size_t frames = 0;  // that the losses are means over: of recordings in which any such time shows
};

// Two of these times can hide one another: a jump after the edge takes that neither of two has run
// out. So the counts can be tried in pairs, which takes a while; of very many they are not.
enum class Tried { singly, inPairs };

// All other coordinates stay. After a stop all do, and the profiles are of no use.
Scan scanOf(const Objective& objective, const std::vector<double>& point, Tried tried,
            const Work& work);

// Of one such time: the counts up to two beside that of the point.
std::vector<double> countsAround(const Objective& objective, const std::vector<double>& point,
                                 size_t coordinate);

// Goes to the best counts, and to the best delay by quarters of a tick, as long as the loss falls:
// an input counts for a whole tick or not at all, so that the delay may show no slope either. True:
// it fell.
bool settle(const Objective& objective, std::vector<double>& point, Tried tried, const Work& work);

}  // namespace obby::calibrate
