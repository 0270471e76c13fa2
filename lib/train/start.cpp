#include "train/start.h"

#include <algorithm>
#include <cmath>

#include "train/engine.h"

namespace obby::train {

namespace {

// Returns a float deviation for which scaleOf() returns `scale`; 0 if there is none.
float deviationOf(float scale) {
  constexpr int kNear = 3;  // units in the last place; the round trip takes up to two
  if (!(scale > 0)) return 0;
  float deviation = 1 / scale;
  for (int i = 0; i < kNear; ++i) deviation = std::nextafter(deviation, 0.0f);
  for (int i = 0; i <= 2 * kNear; ++i) {
    if (scaleOf(double(deviation)) == scale) return deviation;
    deviation = std::nextafter(deviation, INFINITY);
  }
  return 0;
}

}  // namespace

Result<Start> startFrom(const policy::PolicyFile& file) {
  Start start;
  const float* const means = file.network.numbers().data();
  const float* const scales = means + policy::kInputs;
  Sums& seen = start.seen;
  seen.rows = double(file.training.decisions) / kCountEvery;
  for (size_t i = 0; i < seen.sum.size(); ++i) {
    const double mean = double(means[i]), deviation = double(deviationOf(scales[i]));
    seen.sum[i] = seen.rows * mean;
    seen.squares[i] = seen.rows * (mean * mean + deviation * deviation);
    if (float(seen.mean(i)) != means[i] || scaleOf(seen.deviation(i)) != scales[i])
      return makeError("the policy's normalisers are not valid for further training",
                       "name a policy that obby-train wrote");
  }
  nn::LearnerState& learner = start.learner;
  learner.parameters.assign(scales + policy::kInputs, means + policy::Network::kNumbers);
  learner.momentum.assign(learner.parameters.size(), 0.0f);
  learner.squares = learner.momentum;
  if (file.values.deviation > 0) {
    start.learner.values.mean = file.values.mean;
    start.learner.values.deviation = file.values.deviation;
  }
  return start;
}

uint64_t allDecisions(const TrainerState& state) {
  constexpr double kMax = 1e19;  // a damaged file may exceed 64 bits
  return uint64_t(std::min(kMax, state.seen.rows * kCountEvery));
}

}  // namespace obby::train
