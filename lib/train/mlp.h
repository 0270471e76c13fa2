// The network in training: batches of rows, forward and back, on Eigen. Weights are laid out as
// policy::Network has them, so that a trained network is a copy. A template on the scalar, so that
// tests can hold gradients against double precision.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "policy/network.h"

namespace obby::train {

template <class S>
using Rows = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
template <class S>
using Line = Eigen::Matrix<S, 1, Eigen::Dynamic>;

// Weights and biases of the three layers; also their gradients.
template <class S>
struct Weights {
  Rows<S> w[3];
  Line<S> b[3];

  Weights() {
    constexpr int kSizes[] = {policy::kInputs, policy::kHidden, policy::kHidden,
                              policy::kPaddedOutputs};
    for (int l = 0; l < 3; ++l) {
      w[l] = Rows<S>::Zero(kSizes[l], kSizes[l + 1]);
      b[l] = Line<S>::Zero(kSizes[l + 1]);
    }
  }
  void setZero() {
    for (int l = 0; l < 3; ++l) {
      w[l].setZero();
      b[l].setZero();
    }
  }
  // All of them, in the order of blocks().
  std::vector<S> flat() const {
    std::vector<S> all;
    for (int l = 0; l < 3; ++l) {
      all.insert(all.end(), w[l].data(), w[l].data() + w[l].size());
      all.insert(all.end(), b[l].data(), b[l].data() + b[l].size());
    }
    return all;
  }
  void setFlat(const S* from) {
    blocks([&](S* to, size_t count) {
      std::copy_n(from, count, to);
      from += count;
    });
  }
  // Calls visit(data, count) for the six blocks in their order.
  template <class Visit>
  void blocks(Visit&& visit) {
    for (int l = 0; l < 3; ++l) {
      visit(w[l].data(), size_t(w[l].size()));
      visit(b[l].data(), size_t(b[l].size()));
    }
  }
};

// What goes into a Pass, in full: (rows, kInputs), normalised. seen_rows.h has another.
template <class S>
class FullRows {
 public:
  explicit FullRows(const Rows<S>& inputs) : inputs_(inputs) {}  // which must outlive it

  // The first hidden layer.
  void firstLayer(const Weights<S>& net, Rows<S>& out) const {
    out.noalias() = inputs_ * net.w[0];
    out = (out.rowwise() + net.b[0]).cwiseMax(S(0));
  }
  // Adds the gradients of its weights, by the slopes of its sums.
  void addFirstSlopes(const Rows<S>& slope, Weights<S>& sums) const {
    sums.w[0].noalias() += inputs_.transpose() * slope;
  }

 private:
  const Rows<S>& inputs_;
};

// What a batch of rows became on its way through, kept for the way back. Grows to the largest
// batch and is used again: no allocation in a loop.
template <class S>
class Pass {
 public:
  // The outputs: (rows, kPaddedOutputs).
  template <class Inputs>
  const Rows<S>& forward(const Weights<S>& net, const Inputs& inputs) {
    inputs.firstLayer(net, a_);
    b_.noalias() = a_ * net.w[1];
    b_ = (b_.rowwise() + net.b[1]).cwiseMax(S(0));
    out_.noalias() = b_ * net.w[2];
    out_.rowwise() += net.b[2];
    return out_;
  }

  // Adds the gradients to `sums`. `slope`: (rows, kPaddedOutputs), of the loss by the outputs.
  template <class Inputs>
  void backward(const Weights<S>& net, const Inputs& inputs, const Rows<S>& slope,
                Weights<S>& sums) {
    sums.w[2].noalias() += b_.transpose() * slope;
    sums.b[2] += slope.colwise().sum();
    slopeB_.noalias() = slope * net.w[2].transpose();
    stop(slopeB_, b_);
    sums.w[1].noalias() += a_.transpose() * slopeB_;
    sums.b[1] += slopeB_.colwise().sum();
    slopeA_.noalias() = slopeB_ * net.w[1].transpose();
    stop(slopeA_, a_);
    inputs.addFirstSlopes(slopeA_, sums);
    sums.b[0] += slopeA_.colwise().sum();
  }

 private:
  // No slope where a unit was off.
  static void stop(Rows<S>& slope, const Rows<S>& unit) {
    slope = (unit.array() > S(0)).select(slope, S(0));
  }

  Rows<S> a_, b_, out_, slopeA_, slopeB_;
};

}  // namespace obby::train
