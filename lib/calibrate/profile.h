// The loss along one parameter without a gradient.
#pragma once

#include <cstddef>
#include <vector>

namespace obby::calibrate {

struct Profile {
  size_t coordinate;           // index into an objective's point
  std::vector<double> shares;  // the values tried, ascending
  std::vector<double> losses;  // Objective::loss at each
};

// The shares that a profile does not rule out: their losses exceed the minimum by at most `slack`
// (slackOf() in evidence.h).
struct Possible {
  double min, max;
  bool all;  // nothing is ruled out
};
Possible possibleOf(const Profile& profile, double slack);

// Returns true if the losses differ only by rounding; `min` is the smaller one.
bool alike(double loss, double min);

}  // namespace obby::calibrate
