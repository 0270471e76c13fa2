// A pass through networks where there may be a device for it: as Pass<float>, with the same bits.
// Host only.
#pragma once

#include "solve/learned/device_work.h"

namespace obby::solve::learned {

class NetPass {
 public:
  // `device` may be null, and must outlive the pass.
  explicit NetPass(DeviceWork* device = nullptr) : device_(device) {}

  const float* forward(const Net<float>& net, const float* inputs, size_t rows) {
    const auto there = [&](DevicePlayers&, DeviceNets& nets) {
      return there_.forward(nets, net, inputs, rows);
    };
    // Without rows, as in an empty share, there is no memory that a device could be given.
    isThere_ = rows > 0 && device_ != nullptr && device_->tries(there);
    return isThere_ ? there_.outputs() : here_.forward(net, inputs, rows);
  }

  void backward(const Net<float>& net, const float* inputs, size_t rows, const float* slope,
                std::vector<float>& gradient, float* inputSlope = nullptr) {
    if (isThere_) {
      const bool done = device_->tries([&](DevicePlayers&, DeviceNets& nets) {
        return there_.backward(nets, net, rows, slope, gradient, inputSlope);
      });
      if (done) return;
      here_.forward(net, inputs, rows);  // went through the device only
    }
    here_.backward(net, inputs, rows, slope, gradient, inputSlope);
  }

 private:
  DeviceWork* device_;
  bool isThere_ = false;  // went the last rows through the device?
  Pass<float> here_;
  DevicePass there_;
};

}  // namespace obby::solve::learned
