// What the network in training consists of. Laid out as policy::Network has it, so that a trained
// network is a copy. A template on the scalar, so that tests can hold gradients against double
// precision.
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

}  // namespace obby::train
