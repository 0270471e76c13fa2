// The network in training on a device: as Weights and Pass are on the CPU, rounded otherwise, since
// sums run in another order.
#pragma once

#include "train/device/product.h"
#include "train/device/table.h"
#include "train/weights.h"

namespace obby::train {

class DeviceNetwork {
 public:
  static constexpr int kLayers = 3;

  // For so many rows at a time, with gradients of at most `learned` rows.
  Status make(sim::Device& device, uint32_t rows, uint32_t learned);

  // In the order of Weights::blocks: (size).
  float* weights() const { return weights_.data(); }
  size_t size() const { return weights_.size(); }
  float* matrix(int layer) const { return weights() + firsts_[layer]; }
  float* bias(int layer) const { return matrix(layer) + kSizes[layer] * kSizes[layer + 1]; }
  Status put(const Weights<float>& weights) { return weights_.put(weights.flat()); }
  Result<Weights<float>> get() const;

  // `inputs`: (rows, kInputs), on the device.
  Status forward(const float* inputs, uint32_t rows);
  const float* outputs() const { return units_[kLayers - 1].data(); }  // (rows, kPaddedOutputs)

  // After forward(): from slopes() of the loss by the outputs, (rows, kPaddedOutputs), to
  // gradient(), summed over the rows.
  Status backward(const float* inputs, uint32_t rows);
  float* slopes() const { return slopes_[kLayers - 1].data(); }
  float* gradient() const { return gradient_.data(); }  // (size)

 private:
  static constexpr uint32_t kSizes[kLayers + 1] = {policy::kInputs, policy::kHidden,
                                                   policy::kHidden, policy::kPaddedOutputs};

  Status gradientOf(int layer, const float* inputs, uint32_t rows);
  Status slopesBefore(int layer, uint32_t rows);

  sim::Device* device_ = nullptr;
  size_t firsts_[kLayers + 1] = {};
  DeviceTable<float> weights_, gradient_, turned_, chunks_;
  DeviceTable<double> columns_;
  DeviceTable<float> units_[kLayers], slopes_[kLayers];  // (rows, kSizes[layer + 1])
};

}  // namespace obby::train
