#include "nn/device/device_pass.h"

#include <algorithm>

#include "nn/device/sums.h"

namespace obby::nn {

Status DevicePass::reserve(sim::Device& device, const Network<float>& net, uint32_t rows,
                           uint32_t learned) {
  device_ = &device;
  layers_.clear();
  units_.resize(net.layers());
  gradients_.resize(net.layers());
  size_t largest = 0, widest = 0;
  for (size_t l = 0; l < net.layers(); ++l) {
    const size_t inner = net.inputs(l), width = net.outputs(l);
    layers_.push_back({uint32_t(inner), uint32_t(width), net.at(l), net.biasesAt(l)});
    largest = std::max(largest, inner * width);
    widest = std::max(widest, width);
    OBBY_RETURN_IF_ERROR(units_[l].make(device, rows * width));
    OBBY_RETURN_IF_ERROR(gradients_[l].make(device, learned * width));
  }
  OBBY_RETURN_IF_ERROR(transposed_.make(device, largest));
  if (rounding_ == Rounding::asCpu) return {};
  OBBY_RETURN_IF_ERROR(chunks_.make(device, chunksOf(learned, Fused::kGradientRows) * largest));
  return columns_.make(device, chunksOf(learned) * widest);
}

Status DevicePass::multiply(const float* a, const float* b, const float* bias, const float* unit,
                            float* out, uint32_t rows, uint32_t inner, uint32_t columns,
                            bool rectified) {
  const ProductArguments p{a, b, bias, unit, out, rows, inner, columns, rectified};
  return rounding_ == Rounding::fused
             ? enqueue(*device_, kernel(Step::product), p, productTiles<Fused>(p))
             : enqueue(*device_, kernel(Step::productAsCpu), p, productTiles<AsCpu>(p));
}

Status DevicePass::forward(const float* parameters, const float* inputs, uint32_t rows) {
  for (size_t l = 0; l < layers_.size(); ++l) {
    const Layer& layer = layers_[l];
    OBBY_RETURN_IF_ERROR(multiply(l == 0 ? inputs : units_[l - 1].data(),
                                  parameters + layer.weights, parameters + layer.biases, nullptr,
                                  units_[l].data(), rows, layer.inner, layer.columns,
                                  l + 1 < layers_.size()));
  }
  return {};
}

Status DevicePass::backward(const float* parameters, const float* inputs, uint32_t rows,
                            float* gradient, float* inputGradient) {
  for (size_t l = layers_.size(); l-- > 0;) {
    const Layer& layer = layers_[l];
    const float* const from = gradients_[l].data();
    const float* const units = l == 0 ? nullptr : units_[l - 1].data();
    OBBY_RETURN_IF_ERROR(fillGradient(layer, l == 0 ? inputs : units, from, rows, gradient));
    float* const below = l == 0 ? inputGradient : gradients_[l - 1].data();
    if (below == nullptr) break;
    const TransposeArguments turn{parameters + layer.weights, transposed_.data(), layer.inner,
                                  layer.columns};
    OBBY_RETURN_IF_ERROR(
        enqueue(*device_, kernel(Step::transpose), turn, size_t(layer.inner) * layer.columns));
    OBBY_RETURN_IF_ERROR(multiply(from, transposed_.data(), nullptr, units, below, rows,
                                  layer.columns, layer.inner, false));
  }
  return {};
}

Status DevicePass::fillGradient(const Layer& layer, const float* in, const float* outGradient,
                                uint32_t rows, float* gradient) {
  float* const to = gradient + layer.weights;
  GradientArguments g{in, outGradient, to, rows, layer.inner, layer.columns};
  if (rounding_ == Rounding::asCpu) {
    OBBY_RETURN_IF_ERROR(
        enqueue(*device_, kernel(Step::gradientAsCpu), g, gradientTiles<AsCpu>(g)));
  } else {
    g.sums = chunks_.data();
    OBBY_RETURN_IF_ERROR(enqueue(*device_, kernel(Step::gradient), g, gradientTiles<Fused>(g)));
    const RowSumArguments sum{g.sums,
                              nullptr,
                              to,
                              nullptr,
                              chunksOf(rows, Fused::kGradientRows),
                              layer.inner * layer.columns};
    OBBY_RETURN_IF_ERROR(enqueue(*device_, kernel(Step::sumRows), sum, sum.width));
  }
  return fillBiasGradient(outGradient, rows, layer.columns, gradient + layer.biases);
}

Status DevicePass::fillBiasGradient(const float* outGradient, uint32_t rows, uint32_t columns,
                                    float* to) {
  if (rounding_ == Rounding::asCpu) {
    const RowSumArguments sum{outGradient, nullptr, to, nullptr, rows, columns};
    return enqueue(*device_, kernel(Step::sumRows), sum, columns);
  }
  const uint32_t chunks = chunksOf(rows);
  const ColumnSumArguments c{outGradient, columns_.data(), rows, columns};
  OBBY_RETURN_IF_ERROR(enqueue(*device_, kernel(Step::sumColumns), c, size_t(chunks) * columns));
  const RowSumArguments sum{nullptr, columns_.data(), to, nullptr, chunks, columns};
  return enqueue(*device_, kernel(Step::sumRows), sum, columns);
}

}  // namespace obby::nn
