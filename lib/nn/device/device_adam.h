// Adam on a device: what Learner::step is on the CPU. Host only.
#pragma once

#include "nn/learner.h"
#include "sim/device_table.h"

namespace obby::nn {

class DeviceAdam {
 public:
  Status make(sim::Device& device, size_t parameters);
  uint64_t steps() const { return steps_; }

  // Without the parameters.
  Result<LearnerState> state() const;
  Status restore(const LearnerState& state);

  // Moves `parameters` against `gradient`, a sum over `rows`, whose mean is scaled down to
  // `maxGradNorm` where it is longer. `norm` grows by how long it was. All three on the device.
  Status step(float* parameters, const float* gradient, float rows, float maxGradNorm,
              float learningRate, double* norm);

 private:
  sim::Device* device_ = nullptr;
  sim::DeviceTable<float> momentum_, squares_, scale_;
  sim::DeviceTable<double> chunks_;
  uint64_t steps_ = 0;
};

}  // namespace obby::nn
