// Networks on a device for methods that learn while they search, with the bits of the CPU. Learning
// itself stays with the CPU, which is sent the gradients: parameters go there anew after each step.
// Host only.
#pragma once

#include <vector>

#include "nn/device/device_pass.h"

namespace obby::solve::learned {

// Copies of networks' parameters, each brought up to date when it is asked for.
class DeviceNets {
 public:
  // The device must outlive this object, and so must networks that are asked for.
  explicit DeviceNets(sim::Device& device) : device_(device) {}

  sim::Device& device() const { return device_; }
  Result<const float*> parameters(const nn::Network<float>& net);

 private:
  struct Copy {
    const nn::Network<float>* net;
    uint64_t version;
    sim::DeviceTable<float> parameters;
  };

  sim::Device& device_;
  std::vector<Copy> copies_;
};

// A pass of rows that the host has. On failure, what it was given is unchanged.
class DeviceRows {
 public:
  Status forward(DeviceNets& nets, const nn::Network<float>& net, const float* inputs, size_t rows);
  const float* outputs() const { return outputs_.data(); }
  // Of the rows of the last forward(); see nn::Pass.
  Status backward(DeviceNets& nets, const nn::Network<float>& net, const float* gradient,
                  std::vector<float>& sums, float* inputGradient);

 private:
  nn::DevicePass pass_{nn::Rounding::asCpu};
  sim::DeviceTable<float> inputs_, inputGradient_, sums_;
  std::vector<float> outputs_;
};

}  // namespace obby::solve::learned
