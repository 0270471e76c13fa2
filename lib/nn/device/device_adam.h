// Adam on a device, the counterpart of Learner::step. Host only.
#pragma once

#include "nn/learner.h"
#include "sim/device_table.h"

namespace obby::nn {

class DeviceAdam {
 public:
  Status make(sim::Device& device, size_t parameters);
  uint64_t steps() const { return steps_; }

  // Returns the state without the parameters.
  Result<LearnerState> state() const;
  Status restore(const LearnerState& state);

  // Updates `parameters` by `gradient`, a sum over `rows`. Clips the mean gradient to the norm
  // `maxGradNorm`, and adds the unclipped norm to `norm`. All three pointers are device pointers.
  Status step(float* parameters, const float* gradient, float rows, float maxGradNorm,
              float learningRate, double* norm);

 private:
  sim::Device* device_ = nullptr;
  sim::DeviceTable<float> momentum_, squares_, scale_;
  sim::DeviceTable<double> chunks_;
  uint64_t steps_ = 0;
};

}  // namespace obby::nn
