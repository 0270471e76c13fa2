// nn::Pass<float> on a device if there is one, else on the CPU. The bits are the same. Host only.
#pragma once

#include "baselines/device_work.h"
#include "baselines/names.h"
#include "nn/pass.h"

namespace obby::baselines {

// Shares of rows in which gradients are summed (nn::forShares).
constexpr size_t kShares = 4;

class NetPass {
 public:
  // `device` may be null; it must outlive the pass.
  explicit NetPass(DeviceWork* device = nullptr) : device_(device) {}

  const float* forward(const nn::Network<float>& net, const float* inputs, size_t rows) {
    const auto there = [&](DevicePlayers&, DeviceNets& nets) {
      return there_.forward(nets, net, inputs, rows);
    };
    // An empty share has no memory that a device could read.
    isThere_ = rows > 0 && device_ != nullptr && device_->tries(there);
    return isThere_ ? there_.outputs() : here_.forward(net, nn::DenseRows<float>{inputs, rows});
  }

  // Adds the gradient to `sums`. A device adds it in one piece, so the bits are only equal if
  // `sums` are 0.
  void backward(const nn::Network<float>& net, const float* inputs, size_t rows,
                const float* gradient, std::vector<float>& sums, float* inputGradient = nullptr) {
    const nn::DenseRows<float> in{inputs, rows};
    if (isThere_) {
      const bool done = device_->tries([&](DevicePlayers&, DeviceNets& nets) {
        return there_.backward(nets, net, gradient, sums, inputGradient);
      });
      if (done) return;
      here_.forward(net, in);  // it ran only on the device
    }
    here_.backward(net, in, gradient, sums, inputGradient);
  }

 private:
  DeviceWork* device_;
  bool isThere_ = false;  // the last rows ran on the device
  nn::Pass<float> here_;
  DeviceRows there_;
};

}  // namespace obby::baselines
