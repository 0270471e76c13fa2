// How far off the recordings are by one parameter that their errors have no slope by.
#pragma once

#include <cstddef>
#include <vector>

namespace obby::calibrate {

struct Profile {
  size_t coordinate;           // of an objective's point
  std::vector<double> shares;  // of the bounds, ascending
  std::vector<double> losses;  // Objective::loss of each
};

// The shares that a profile leaves possible: their losses exceed the least one by no more than
// `slack` (slackOf() in evidence.h).
struct Possible {
  double least, most;
  bool all;  // nothing is ruled out
};
Possible possibleOf(const Profile& profile, double slack);

// Losses that differ by rounding only; `least` is the smaller.
bool alike(double loss, double least);

}  // namespace obby::calibrate
