// Networks on a device, for methods that learn during the search. Results have the same bits as the
// CPU's. The optimiser runs on the CPU: it receives the gradients, and the device its new
// parameters after each step. Host only.
#pragma once

#include <vector>

#include "baselines/names.h"
#include "nn/device/device_pass.h"

namespace obby::baselines {

// Copies of networks' parameters on the device. parameters() updates a copy if its network has
// changed.
class DeviceNets {
 public:
  // The device and all requested networks must outlive this object.
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

// A pass over rows in host memory. On failure its arguments are unchanged.
class DeviceRows {
 public:
  Status forward(DeviceNets& nets, const nn::Network<float>& net, const float* inputs, size_t rows);
  const float* outputs() const { return outputs_.data(); }
  // Call it after forward() for the same rows; see nn::Pass.
  Status backward(DeviceNets& nets, const nn::Network<float>& net, const float* gradient,
                  std::vector<float>& sums, float* inputGradient);

 private:
  nn::DevicePass pass_{nn::Rounding::asCpu};
  sim::DeviceTable<float> inputs_, inputGradient_, sums_;
  std::vector<float> outputs_;
};

}  // namespace obby::baselines
