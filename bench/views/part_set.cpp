#include <algorithm>
#include <iterator>

#include "base/random.h"
#include "views/other_views.h"
#include "views/view_frame.h"

namespace obby::bench {

namespace {

constexpr uint64_t kSeed = 0x736574;
// Max magnitudes of the random weights and biases. About four of a part's numbers are of order 1,
// so the features are, too.
constexpr float kMaxWeight = 0.9f, kMaxBias = 0.5f;
constexpr float kFade = 8;  // distance at which a part counts half, studs

class Features {
 public:
  Features() {
    Random random(kSeed, 0);
    const auto upTo = [&random](float max) { return max * (2 * random.unit() - 1); };
    for (auto& row : weights_) {
      for (float& w : row) w = upTo(kMaxWeight);
    }
    for (float& b : biases_) b = upTo(kMaxBias);
  }

  // Raises `pooled` (kViewInputs, at least 0) to the part's features.
  void pool(const PartInSight& part, float* pooled) const {
    float sums[kViewInputs];
    std::copy(std::begin(biases_), std::end(biases_), sums);
    for (int n = 0; n < kPartNumbers; ++n) {
      const float number = part.features[size_t(n)];
      for (int i = 0; i < kViewInputs; ++i) sums[i] += weights_[n][i] * number;
    }
    const float weight = kFade / (kFade + part.distance);
    for (int i = 0; i < kViewInputs; ++i) pooled[i] = maxf(pooled[i], weight * sums[i]);
  }

 private:
  float weights_[kPartNumbers][kViewInputs], biases_[kViewInputs];
};

}  // namespace

Turns partSet(const policy::Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
              float* inputs) {
  static const Features features;
  const Turns ahead = observeAllButMaps(scene, world, bodies, inputs);
  for (const PartInSight& part : partsInSight(scene, world, bodies, ahead))
    features.pool(part, inputs + policy::kMapsAt);
  return ahead;
}

}  // namespace obby::bench
