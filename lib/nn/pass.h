// Rows on their way through a network and back, on the CPU. The order of sums is fixed
// (nn/product.h). Host only.
#pragma once

#include <algorithm>
#include <vector>

#include "nn/network.h"

namespace obby::nn {

// out = in W + b of layer l. `in`: (rows, inputs of the layer); `out`: (rows, outputs).
template <class S>
void linear(const Network<S>& net, size_t l, const S* in, size_t rows, S* out) {
  const size_t width = net.outputs(l), inner = net.inputs(l);
  for (size_t r = 0; r < rows; ++r) std::copy_n(net.biases(l), width, out + r * width);
  addProduct<S>({in, inner, 1}, rows, inner, net.weights(l), width, out);
}

// Adds the gradient of layer l's parameters to `sums`, laid out as they are. `gradient`: (rows,
// outputs), of the loss by the layer's outputs.
template <class S>
void addLinearGradient(const Network<S>& net, size_t l, const S* in, size_t rows, const S* gradient,
                       std::vector<S>& sums) {
  const size_t width = net.outputs(l), inner = net.inputs(l);
  addProduct<S>({in, 1, inner}, inner, rows, gradient, width, sums.data() + net.at(l));
  S* const biases = sums.data() + net.biasesAt(l);
  for (size_t r = 0; r < rows; ++r) {
    for (size_t o = 0; o < width; ++o) biases[o] += gradient[r * width + o];
  }
}

// Inputs of a Pass as they lie. Another type may keep them otherwise (train/seen_rows.h).
template <class S>
struct DenseRows {
  const S* at;  // (count, net.inputs(0))
  size_t count;

  size_t rows() const { return count; }
  // The first layer's outputs, before they are rectified.
  void firstLayer(const Network<S>& net, S* out) const { linear(net, 0, at, count, out); }
  void addFirstGradient(const Network<S>& net, const S* gradient, std::vector<S>& sums) const {
    addLinearGradient(net, 0, at, count, gradient, sums);
  }
};

// Keeps on the way there what the way back needs. Memory grows to the most rows and is used again.
template <class S>
class Pass {
 public:
  // The outputs: (rows, net.outputs()).
  template <class Inputs>
  const S* forward(const Network<S>& net, const Inputs& inputs) {
    const size_t rows = inputs.rows();
    units_.resize(net.layers());
    for (size_t l = 0; l < net.layers(); ++l) {
      const size_t count = rows * net.outputs(l);
      std::vector<S>& out = units_[l];
      if (out.size() < count) out.resize(count);
      if (l == 0) {
        inputs.firstLayer(net, out.data());
      } else {
        linear(net, l, units_[l - 1].data(), rows, out.data());
      }
      if (l + 1 == net.layers()) break;
      for (size_t i = 0; i < count; ++i) out[i] = out[i] > S(0) ? out[i] : S(0);
    }
    return units_.back().data();
  }

  // After forward() of these inputs: adds the gradient of the parameters to `sums`. `gradient`:
  // (rows, net.outputs()), of the loss by the outputs. `inputGradient`: filled, (rows,
  // net.inputs(0)), or null; with it the inputs must be a multiple of kColumns.
  template <class Inputs>
  void backward(const Network<S>& net, const Inputs& inputs, const S* gradient,
                std::vector<S>& sums, S* inputGradient = nullptr) {
    const size_t rows = inputs.rows();
    for (size_t l = net.layers() - 1; l > 0; --l) {
      const S* const in = units_[l - 1].data();
      addLinearGradient(net, l, in, rows, gradient, sums);
      const size_t count = rows * net.inputs(l);
      std::vector<S>& below = below_[l % 2];
      if (below.size() < count) below.resize(count);
      fillBack(net, l, gradient, rows, below.data());
      for (size_t i = 0; i < count; ++i) below[i] = in[i] > S(0) ? below[i] : S(0);
      gradient = below.data();
    }
    inputs.addFirstGradient(net, gradient, sums);
    if (inputGradient != nullptr) fillBack(net, 0, gradient, rows, inputGradient);
  }

 private:
  // to = gradient W^T.
  void fillBack(const Network<S>& net, size_t l, const S* gradient, size_t rows, S* to) {
    const size_t inner = net.inputs(l), width = net.outputs(l);
    if (transposed_.size() < inner * width) transposed_.resize(inner * width);
    const S* const w = net.weights(l);
    for (size_t first = 0; first < inner; first += kColumns) {
      for (size_t o = 0; o < width; ++o) {
        for (size_t i = first; i < first + kColumns; ++i)
          transposed_[o * inner + i] = w[i * width + o];
      }
    }
    std::fill_n(to, rows * inner, S(0));
    addProduct<S>({gradient, width, 1}, rows, width, transposed_.data(), inner, to);
  }

  std::vector<std::vector<S>> units_;  // of each layer, (rows, outputs)
  std::vector<S> below_[2];            // gradients by a layer's inputs
  std::vector<S> transposed_;          // weights of a layer
};

}  // namespace obby::nn
