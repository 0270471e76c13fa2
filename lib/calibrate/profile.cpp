#include "calibrate/profile.h"

#include <algorithm>

namespace obby::calibrate {

namespace {

constexpr double kSameLoss = 1e-9;  // relative

}  // namespace

bool alike(double loss, double min) { return loss <= min * (1 + kSameLoss); }

Possible possibleOf(const Profile& profile, double slack) {
  const double min = *std::min_element(profile.losses.begin(), profile.losses.end());
  const auto possible = [&](double loss) { return loss <= min + slack || alike(loss, min); };
  size_t first = 0, last = profile.losses.size() - 1;
  while (!possible(profile.losses[first])) ++first;
  while (!possible(profile.losses[last])) --last;
  return {profile.shares[first], profile.shares[last],
          first == 0 && last + 1 == profile.losses.size()};
}

}  // namespace obby::calibrate
