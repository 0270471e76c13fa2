// Forward and backward passes on the CPU. The order of sums is fixed (nn/product.h). Host only.
#pragma once

#include <algorithm>
#include <vector>

#include "nn/network.h"

namespace obby::nn {

// Computes out = in W + b for layer l, rectified unless it is the last. `in`: (rows, inputs of the
// layer); `out`: (rows, outputs).
template <class S>
void fillLayer(const Network<S>& net, size_t l, const S* in, size_t rows, S* out) {
  multiply(Product<S>{in, net.weights(l), net.biases(l), nullptr, out, rows, net.inputs(l),
                      net.outputs(l), l + 1 < net.layers()});
}

// Adds the gradient of layer l's parameters to `sums`, which has their layout. `gradient`: (rows,
// outputs), of the loss with respect to the layer's sums.
template <class S>
void addLayerGradient(const Network<S>& net, size_t l, const S* in, size_t rows, const S* gradient,
                      std::vector<S>& sums) {
  addGradient(GradientProduct<S>{in, gradient, sums.data() + net.at(l),
                                 sums.data() + net.biasesAt(l), rows, net.inputs(l),
                                 net.outputs(l)});
}

// Dense inputs of a Pass. train/seen_rows.h has a sparse form.
template <class S>
struct DenseRows {
  const S* at;  // (count, net.inputs(0))
  size_t count;

  size_t rows() const { return count; }
  void fillFirstLayer(const Network<S>& net, S* out) const { fillLayer(net, 0, at, count, out); }
  void addFirstGradient(const Network<S>& net, const S* gradient, std::vector<S>& sums) const {
    addLayerGradient(net, 0, at, count, gradient, sums);
  }
};

// Runs passes, and keeps what backward() needs. Memory grows to the largest number of rows and is
// reused.
template <class S>
class Pass {
 public:
  // Returns the outputs, (rows, net.outputs()).
  template <class Inputs>
  const S* forward(const Network<S>& net, const Inputs& inputs) {
    const size_t rows = inputs.rows();
    units_.resize(net.layers());
    for (size_t l = 0; l < net.layers(); ++l) {
      const size_t count = rows * net.outputs(l);
      std::vector<S>& out = units_[l];
      if (out.size() < count) out.resize(count);
      if (l == 0) {
        inputs.fillFirstLayer(net, out.data());
      } else {
        fillLayer(net, l, units_[l - 1].data(), rows, out.data());
      }
    }
    return units_.back().data();
  }

  // Call it after forward() with the same inputs. Adds the gradient of the parameters to `sums`.
  // `gradient`: (rows, net.outputs()), of the loss with respect to the outputs. Fills
  // `inputGradient`, (rows, net.inputs(0)), unless null; then that width must be a multiple of
  // kColumns.
  template <class Inputs>
  void backward(const Network<S>& net, const Inputs& inputs, const S* gradient,
                std::vector<S>& sums, S* inputGradient = nullptr) {
    const size_t rows = inputs.rows();
    for (size_t l = net.layers() - 1; l > 0; --l) {
      const S* const in = units_[l - 1].data();
      addLayerGradient(net, l, in, rows, gradient, sums);
      std::vector<S>& below = below_[l % 2];
      if (below.size() < rows * net.inputs(l)) below.resize(rows * net.inputs(l));
      fillBack(net, l, gradient, rows, in, below.data());
      gradient = below.data();
    }
    inputs.addFirstGradient(net, gradient, sums);
    if (inputGradient != nullptr) fillBack(net, 0, gradient, rows, nullptr, inputGradient);
  }

 private:
  // Computes to = gradient W^T. Elements whose unit in `units` is off become 0. `units` may be
  // null.
  void fillBack(const Network<S>& net, size_t l, const S* gradient, size_t rows, const S* units,
                S* to) {
    const size_t inner = net.inputs(l), width = net.outputs(l);
    if (transposed_.size() < inner * width) transposed_.resize(inner * width);
    const S* const w = net.weights(l);
    for (size_t first = 0; first < inner; first += kColumns) {
      for (size_t o = 0; o < width; ++o) {
        for (size_t i = first; i < first + kColumns; ++i)
          transposed_[o * inner + i] = w[i * width + o];
      }
    }
    multiply(
        Product<S>{gradient, transposed_.data(), nullptr, units, to, rows, width, inner, false});
  }

  std::vector<std::vector<S>> units_;  // one per layer, (rows, outputs)
  std::vector<S> below_[2];            // gradients of a layer's inputs
  std::vector<S> transposed_;          // weights of a layer
};

}  // namespace obby::nn
