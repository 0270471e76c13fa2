#include "train/device/device_network.h"

#include "train/device/sums.h"

namespace obby::train {

Status DeviceNetwork::make(sim::Device& device, uint32_t rows, uint32_t learned) {
  device_ = &device;
  size_t largest = 0;
  for (int l = 0; l < kLayers; ++l) {
    const size_t numbers = size_t(kSizes[l]) * kSizes[l + 1];
    largest = std::max(largest, numbers);
    firsts_[l + 1] = firsts_[l] + numbers + kSizes[l + 1];
    OBBY_RETURN_IF_ERROR(units_[l].make(device, size_t(rows) * kSizes[l + 1]));
    OBBY_RETURN_IF_ERROR(slopes_[l].make(device, size_t(learned) * kSizes[l + 1]));
  }
  OBBY_RETURN_IF_ERROR(weights_.makeZero(device, firsts_[kLayers]));
  OBBY_RETURN_IF_ERROR(gradient_.makeZero(device, firsts_[kLayers]));
  OBBY_RETURN_IF_ERROR(turned_.make(device, largest));
  OBBY_RETURN_IF_ERROR(chunks_.make(device, gradientChunks(learned) * largest));
  return columns_.make(device, size_t(chunksOf(learned)) * policy::kHidden);
}

Result<Weights<float>> DeviceNetwork::get() const {
  OBBY_ASSIGN(const std::vector<float> flat, weights_.get());
  Weights<float> weights;
  weights.setFlat(flat.data());
  return weights;
}

Status DeviceNetwork::forward(const float* inputs, uint32_t rows) {
  for (int l = 0; l < kLayers; ++l) {
    const ProductArguments p{l == 0 ? inputs : units_[l - 1].data(),
                             matrix(l),
                             bias(l),
                             nullptr,
                             units_[l].data(),
                             rows,
                             kSizes[l],
                             kSizes[l + 1],
                             l + 1 < kLayers};
    OBBY_RETURN_IF_ERROR(enqueue(*device_, TrainStep::product, p, productTiles(p)));
  }
  return {};
}

Status DeviceNetwork::backward(const float* inputs, uint32_t rows) {
  for (int l = kLayers - 1; l >= 0; --l) {
    OBBY_RETURN_IF_ERROR(gradientOf(l, l == 0 ? inputs : units_[l - 1].data(), rows));
    if (l > 0) OBBY_RETURN_IF_ERROR(slopesBefore(l, rows));
  }
  return {};
}

Status DeviceNetwork::gradientOf(int l, const float* inputs, uint32_t rows) {
  const uint32_t inner = kSizes[l], columns = kSizes[l + 1];
  const GradientArguments g{inputs, slopes_[l].data(), chunks_.data(), rows, inner, columns};
  OBBY_RETURN_IF_ERROR(enqueue(*device_, TrainStep::gradient, g, gradientTiles(g)));
  float* const to = gradient() + firsts_[l];
  const RowSumArguments sum{chunks_.data(),       nullptr,        to, nullptr,
                            gradientChunks(rows), inner * columns};
  OBBY_RETURN_IF_ERROR(enqueue(*device_, TrainStep::sumRows, sum, sum.width));
  const uint32_t chunks = chunksOf(rows);
  const ColumnSumArguments c{slopes_[l].data(), columns_.data(), rows, columns};
  OBBY_RETURN_IF_ERROR(enqueue(*device_, TrainStep::sumColumns, c, size_t(chunks) * columns));
  const RowSumArguments biases{nullptr, columns_.data(), to + inner * columns,
                               nullptr, chunks,          columns};
  return enqueue(*device_, TrainStep::sumRows, biases, columns);
}

// Of the units that the layer reads: none where a unit was off.
Status DeviceNetwork::slopesBefore(int l, uint32_t rows) {
  const uint32_t inner = kSizes[l], columns = kSizes[l + 1];
  const TransposeArguments turn{matrix(l), turned_.data(), inner, columns};
  OBBY_RETURN_IF_ERROR(enqueue(*device_, TrainStep::transpose, turn, size_t(inner) * columns));
  const ProductArguments p{
      slopes_[l].data(), turned_.data(), nullptr, units_[l - 1].data(), slopes_[l - 1].data(), rows,
      columns,           inner,          false};
  return enqueue(*device_, TrainStep::product, p, productTiles(p));
}

}  // namespace obby::train
