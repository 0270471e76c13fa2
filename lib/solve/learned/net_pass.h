// A pass through networks where there may be a device for it: as nn::Pass<float>, with the same
// bits. Host only.
#pragma once

#include "nn/pass.h"
#include "solve/learned/device_work.h"

namespace obby::solve::learned {

// Shares of rows that learning gathers gradients in (nn::forShares).
constexpr size_t kShares = 4;

class NetPass {
 public:
  // `device` may be null, and must outlive the pass.
  explicit NetPass(DeviceWork* device = nullptr) : device_(device) {}

  const float* forward(const nn::Network<float>& net, const float* inputs, size_t rows) {
    const auto there = [&](DevicePlayers&, DeviceNets& nets) {
      return there_.forward(nets, net, inputs, rows);
    };
    // Without rows, as in an empty share, there is no memory that a device could be given.
    isThere_ = rows > 0 && device_ != nullptr && device_->tries(there);
    return isThere_ ? there_.outputs() : here_.forward(net, nn::DenseRows<float>{inputs, rows});
  }

  // Adds to `sums`, which a device adds to in one piece: with the same bits where they are 0.
  void backward(const nn::Network<float>& net, const float* inputs, size_t rows,
                const float* gradient, std::vector<float>& sums, float* inputGradient = nullptr) {
    const nn::DenseRows<float> in{inputs, rows};
    if (isThere_) {
      const bool done = device_->tries([&](DevicePlayers&, DeviceNets& nets) {
        return there_.backward(nets, net, gradient, sums, inputGradient);
      });
      if (done) return;
      here_.forward(net, in);  // went through the device only
    }
    here_.backward(net, in, gradient, sums, inputGradient);
  }

 private:
  DeviceWork* device_;
  bool isThere_ = false;  // went the last rows through the device?
  nn::Pass<float> here_;
  DeviceRows there_;
};

}  // namespace obby::solve::learned
