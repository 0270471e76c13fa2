#include "calibrate/noise.h"

#include <algorithm>
#include <cmath>

namespace obby::calibrate {

// Measures how far positions are from the mean of their neighbours. Landings and turns hardly move
// the median of all.
double noiseOf(std::span<const Take> takes) {
  std::vector<double> sizes;
  for (const Take& take : takes) {
    const auto& f = take.track.frames;
    for (size_t i = 1; i + 1 < f.size(); ++i) {
      const float share = float((f[i].time - f[i - 1].time) / (f[i + 1].time - f[i - 1].time));
      const Vec3 between = f[i - 1].position + (f[i + 1].position - f[i - 1].position) * share;
      sizes.push_back(double(length(f[i].position - between)));
    }
  }
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  // A difference from the mean of two has one and a half times the variance of one value.
  return *middle / std::sqrt(1.5);
}

}  // namespace obby::calibrate
