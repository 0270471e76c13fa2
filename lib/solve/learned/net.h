// A network of dense layers with rectified units between, forward and back over rows of inputs.
// Sums run in a fixed order (product.h). A template on the number type, so that tests can hold
// gradients against double precision. Host only.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/random.h"
#include "math/lanes.h"
#include "solve/learned/product.h"

namespace obby::solve::learned {

// The least multiple of kColumns that is not below `count`.
constexpr size_t padded(size_t count) { return (count + kColumns - 1) / kColumns * kColumns; }

template <class S>
class Net {
 public:
  // `sizes`: units of each layer, the inputs first; all but the inputs multiples of kColumns.
  explicit Net(std::vector<size_t> sizes) : sizes_(std::move(sizes)) {
    size_t count = 0;
    for (size_t l = 0; l < layers(); ++l) {
      OBBY_CHECK_EQ(outputs(l) % kColumns, 0u);
      at_.push_back(count);
      count += (inputs(l) + 1) * outputs(l);
    }
    numbers_.assign(count, S(0));
  }

  size_t layers() const { return sizes_.size() - 1; }
  size_t inputs(size_t l) const { return sizes_[l]; }
  size_t outputs(size_t l) const { return sizes_[l + 1]; }
  size_t outputs() const { return sizes_.back(); }

  // Of each layer: weights, then biases. Who gets them this way is taken to change them.
  std::vector<S>& numbers() {
    ++version_;
    return numbers_;
  }
  const std::vector<S>& numbers() const { return numbers_; }
  // (inputs, outputs) of layer l, and (outputs).
  const S* weights(size_t l) const { return numbers_.data() + at_[l]; }
  const S* biases(size_t l) const { return weights(l) + inputs(l) * outputs(l); }
  size_t at(size_t l) const { return at_[l]; }   // of the layer in numbers()
  uint64_t version() const { return version_; }  // grows with each change; above 0

 private:
  std::vector<size_t> sizes_, at_;
  std::vector<S> numbers_;
  uint64_t version_ = 1;
};

// Weights uniform within sqrt(6 / inputs), those of the last layer times `gain`; no biases.
inline void fillRandom(Net<float>& net, float gain, Random& random) {
  for (size_t l = 0; l < net.layers(); ++l) {
    const float most = sqrtf32(6.0f / float(net.inputs(l))) * (l + 1 == net.layers() ? gain : 1);
    float* const w = net.numbers().data() + net.at(l);
    for (size_t i = 0; i < net.inputs(l) * net.outputs(l); ++i)
      w[i] = most * (2 * random.unit() - 1);
  }
}

// What rows became on their way through a net, kept for the way back. Grows to the most rows and is
// used again.
template <class S>
class Pass {
 public:
  // `inputs`: (rows, net.inputs(0)). Gives the outputs, (rows, net.outputs()).
  const S* forward(const Net<S>& net, const S* inputs, size_t rows) {
    units_.resize(net.layers());
    const S* in = inputs;
    for (size_t l = 0; l < net.layers(); ++l) {
      const size_t width = net.outputs(l);
      std::vector<S>& out = units_[l];
      out.resize(std::max(out.size(), rows * width));
      for (size_t r = 0; r < rows; ++r) std::copy_n(net.biases(l), width, out.data() + r * width);
      const size_t inner = net.inputs(l);
      addProduct<S>({in, inner, 1}, rows, inner, net.weights(l), width, out.data());
      if (l + 1 < net.layers()) {
        for (size_t i = 0; i < rows * width; ++i) out[i] = out[i] > S(0) ? out[i] : S(0);
      }
      in = out.data();
    }
    return in;
  }

  // Adds the gradient of the rows of the last forward() to `gradient`, laid out as net.numbers().
  // `slope`: (rows, net.outputs()), of the loss by the outputs. `inputSlope`: (rows, net.inputs(0))
  // to be added to, or null; with it the inputs must be a multiple of kColumns.
  void backward(const Net<S>& net, const S* inputs, size_t rows, const S* slope,
                std::vector<S>& gradient, S* inputSlope = nullptr) {
    below_.resize(2);
    for (size_t l = net.layers(); l-- > 0;) {
      const size_t inner = net.inputs(l), width = net.outputs(l);
      const S* const in = l == 0 ? inputs : units_[l - 1].data();
      S* const weights = gradient.data() + net.at(l);
      addProduct<S>({in, 1, inner}, inner, rows, slope, width, weights);
      S* const biases = weights + inner * width;
      for (size_t r = 0; r < rows; ++r) {
        for (size_t o = 0; o < width; ++o) biases[o] += slope[r * width + o];
      }
      if (l == 0) {
        if (inputSlope != nullptr) addBack(net, l, slope, rows, inputSlope);
        return;
      }
      std::vector<S>& next = below_[l % 2];
      next.assign(rows * inner, S(0));
      addBack(net, l, slope, rows, next.data());
      for (size_t i = 0; i < rows * inner; ++i) next[i] = in[i] > S(0) ? next[i] : S(0);
      slope = next.data();
    }
  }

 private:
  // Adds slope W^T to `to`.
  void addBack(const Net<S>& net, size_t l, const S* slope, size_t rows, S* to) {
    const size_t inner = net.inputs(l), width = net.outputs(l);
    turned_.resize(inner * width);
    const S* const w = net.weights(l);
    for (size_t first = 0; first < inner; first += kColumns) {
      for (size_t o = 0; o < width; ++o) {
        for (size_t i = first; i < first + kColumns; ++i) turned_[o * inner + i] = w[i * width + o];
      }
    }
    addProduct<S>({slope, width, 1}, rows, width, turned_.data(), inner, to);
  }

  std::vector<std::vector<S>> units_;  // of each layer, (rows, outputs)
  std::vector<std::vector<S>> below_;  // slopes by a layer's inputs
  std::vector<S> turned_;              // weights, transposed
};

}  // namespace obby::solve::learned
