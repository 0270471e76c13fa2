// Networks on a device, with the bits of net.h: the numbers of those that are asked for, and what
// rows become on their way through. Learning itself stays with the CPU, which is sent the
// gradients: numbers go there anew after each step. Host only.
#pragma once

#include <vector>

#include "sim/device.h"
#include "solve/learned/net.h"

namespace obby::solve::learned {

// Copies of networks, each brought up to date when it is asked for.
class DeviceNets {
 public:
  // The device must outlive this object, and so must networks that are asked for.
  explicit DeviceNets(sim::Device& device) : device_(device) {}

  sim::Device& device() const { return device_; }
  // net.numbers() there.
  Result<const float*> numbers(const Net<float>& net);

 private:
  struct Copy {
    const Net<float>* net;
    uint64_t version;
    sim::Memory memory;
  };

  sim::Device& device_;
  std::vector<Copy> copies_;
};

// As Pass, on a device. What failed has changed nothing that it was given.
class DevicePass {
 public:
  Status forward(DeviceNets& nets, const Net<float>& net, const float* inputs, size_t rows);
  const float* outputs() const { return outputs_.data(); }
  // Of the rows of the last forward().
  Status backward(DeviceNets& nets, const Net<float>& net, size_t rows, const float* slope,
                  std::vector<float>& gradient, float* inputSlope);

 private:
  Status layersBack(DeviceNets& nets, const Net<float>& net, size_t rows, bool toInputs);

  sim::Memory inputs_, gradient_;
  std::vector<sim::Memory> units_;   // of each layer, (rows, outputs)
  std::vector<sim::Memory> slopes_;  // by the inputs, then by the units of each layer
  std::vector<float> outputs_;
};

}  // namespace obby::solve::learned
