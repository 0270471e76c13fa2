#include "nn/device/device_adam.h"

#include "nn/device/kernels.h"
#include "nn/device/learn_kernels.h"

namespace obby::nn {

Status DeviceAdam::make(sim::Device& device, size_t parameters) {
  device_ = &device;
  OBBY_RETURN_IF_ERROR(momentum_.makeZero(device, parameters));
  OBBY_RETURN_IF_ERROR(squares_.makeZero(device, parameters));
  OBBY_RETURN_IF_ERROR(scale_.make(device, 1));
  return chunks_.make(device, chunksOf(uint32_t(parameters)));
}

Result<LearnerState> DeviceAdam::state() const {
  LearnerState out;
  OBBY_ASSIGN(out.momentum, momentum_.get());
  OBBY_ASSIGN(out.squares, squares_.get());
  out.steps = steps_;
  return out;
}

Status DeviceAdam::restore(const LearnerState& state) {
  steps_ = state.steps;
  OBBY_RETURN_IF_ERROR(momentum_.put(state.momentum));
  return squares_.put(state.squares);
}

Status DeviceAdam::step(float* parameters, const float* gradient, float rows, float maxGradNorm,
                        float learningRate, double* norm) {
  const auto size = uint32_t(momentum_.size());
  const StepArguments s{parameters,
                        momentum_.data(),
                        squares_.data(),
                        gradient,
                        size,
                        rows,
                        chunks_.data(),
                        maxGradNorm,
                        AdamStep::at(++steps_, learningRate),
                        scale_.data(),
                        norm};
  OBBY_RETURN_IF_ERROR(enqueue(*device_, kernel(Step::squares), s, chunksOf(size)));
  OBBY_RETURN_IF_ERROR(enqueue(*device_, kernel(Step::scale), s, 1));
  return enqueue(*device_, kernel(Step::update), s, size);
}

}  // namespace obby::nn
