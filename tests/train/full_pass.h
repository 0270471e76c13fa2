// The network in training as a formula: rows in full, products by Eigen, any scalar. What the
// library computes is held against it.
#pragma once

#include "train/weights.h"

namespace obby::train {

template <class S>
class FullPass {
 public:
  // `inputs`: (rows, kInputs), normalised. The outputs: (rows, kPaddedOutputs).
  const Rows<S>& forward(const Weights<S>& net, const Rows<S>& inputs) {
    a_ = ((inputs * net.w[0]).rowwise() + net.b[0]).cwiseMax(S(0));
    b_ = ((a_ * net.w[1]).rowwise() + net.b[1]).cwiseMax(S(0));
    out_ = (b_ * net.w[2]).rowwise() + net.b[2];
    return out_;
  }

  // Adds the gradients to `sums`. `slope`: (rows, kPaddedOutputs), of the loss by the outputs.
  void backward(const Weights<S>& net, const Rows<S>& inputs, const Rows<S>& slope,
                Weights<S>& sums) {
    const Rows<S> slopeB = whereOn(b_, slope * net.w[2].transpose());
    const Rows<S> slopeA = whereOn(a_, slopeB * net.w[1].transpose());
    add(b_, slope, 2, sums);
    add(a_, slopeB, 1, sums);
    add(inputs, slopeA, 0, sums);
  }

 private:
  static Rows<S> whereOn(const Rows<S>& unit, const Rows<S>& slope) {
    return (unit.array() > S(0)).select(slope, S(0));
  }
  static void add(const Rows<S>& in, const Rows<S>& slope, int layer, Weights<S>& sums) {
    sums.w[layer] += in.transpose() * slope;
    sums.b[layer] += slope.colwise().sum();
  }

  Rows<S> a_, b_, out_;
};

}  // namespace obby::train
