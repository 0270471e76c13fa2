// Forward and backward passes on a device, the counterpart of Pass. Bits are equal to the CPU's
// with Rounding::asCpu. Rounding::fused is faster and sums in another order. Host only.
#pragma once

#include "nn/device/kernels.h"
#include "nn/network.h"
#include "sim/device_table.h"

namespace obby::nn {

enum class Rounding { fused, asCpu };  // see Fused and AsCpu in nn/device/product.h

class DevicePass {
 public:
  explicit DevicePass(Rounding rounding) : rounding_(rounding) {}

  // Allocates memory for `rows` rows at a time, of which up to `learned` go through backward().
  // Call it first; it discards earlier contents.
  Status reserve(sim::Device& device, const Network<float>& net, uint32_t rows, uint32_t learned);

  // All pointers are to device memory. `parameters` have the layout of Network; `inputs`: (rows,
  // inputs).
  Status forward(const float* parameters, const float* inputs, uint32_t rows);
  const float* outputs() const { return units_.back().data(); }  // (rows, outputs)

  // Call it after forward(), with outputGradient(), (rows, outputs), filled. Fills `gradient` of
  // the parameters, summed over the rows, and, unless null, `inputGradient`, (rows, inputs).
  Status backward(const float* parameters, const float* inputs, uint32_t rows, float* gradient,
                  float* inputGradient = nullptr);
  float* outputGradient() const { return gradients_.back().data(); }

 private:
  struct Layer {
    uint32_t inner, columns;
    size_t weights, biases;  // offsets into the parameters
  };
  Status multiply(const float* a, const float* b, const float* bias, const float* unit, float* out,
                  uint32_t rows, uint32_t inner, uint32_t columns, bool rectified);
  Status fillGradient(const Layer& layer, const float* in, const float* outGradient, uint32_t rows,
                      float* gradient);
  Status fillBiasGradient(const float* outGradient, uint32_t rows, uint32_t columns, float* to);

  Rounding rounding_;
  sim::Device* device_ = nullptr;
  std::vector<Layer> layers_;
  std::vector<sim::DeviceTable<float>> units_, gradients_;  // one per layer, (rows, outputs)
  sim::DeviceTable<float> transposed_, chunks_;
  sim::DeviceTable<double> columns_;
};

}  // namespace obby::nn
