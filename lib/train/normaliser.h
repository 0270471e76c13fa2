// Running mean and deviation of a stream of rows, and the scale of returns made from them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "train/ranks.h"

namespace obby::train {

// Sums of some rows. Added in a fixed order, they have the same bits however the rows are split.
struct Sums {
  explicit Sums(size_t width) : sum(width, 0), squares(width, 0) {}

  void add(const float* row) {
    for (size_t i = 0; i < sum.size(); ++i) {
      const double v = double(row[i]);
      sum[i] += v;
      squares[i] += v * v;
    }
    ++rows;
  }
  void add(const Sums& other) {
    for (size_t i = 0; i < sum.size(); ++i) {
      sum[i] += other.sum[i];
      squares[i] += other.squares[i];
    }
    rows += other.rows;
  }
  // Adds up the sums of all ranks, in order.
  void add(Ranks& ranks) {
    ranks.add(sum);
    ranks.add(squares);
    ranks.add({&rows, 1});
  }
  // Multiplies the weight of all rows so far by `share`.
  void fade(double share) {
    for (size_t i = 0; i < sum.size(); ++i) {
      sum[i] *= share;
      squares[i] *= share;
    }
    rows *= share;
  }

  double mean(size_t i) const { return rows > 0 ? sum[i] / rows : 0; }
  double deviation(size_t i) const {
    if (!(rows > 0)) return 1;
    const double m = mean(i), variance = squares[i] / rows - m * m;
    return std::sqrt(std::max(variance, 0.0));
  }

  std::vector<double> sum, squares;
  double rows = 0;
};

// scaleOf() returns the factor that normalises an input. The min deviation keeps nearly constant
// inputs from being magnified.
constexpr float kMinDeviation = 0.02f;
inline float scaleOf(double deviation) { return 1 / std::max(float(deviation), kMinDeviation); }

// The scale of the value head. The head learns returns of mean 0 and deviation 1. When the scale
// changes, the head's weights change so that its values stay the same (Pop-Art, van Hasselt et al.
// 2016).
struct ValueScale {
  float mean = 0, deviation = 1;  // a return, in rewards, is mean + deviation x output
  Sums returns{1};

  // Adds the returns of another batch of this rank.
  void take(Sums now, Ranks& ranks) {
    constexpr double kFade = 0.95;  // weight of earlier returns, per batch
    constexpr float kMin = 1e-3f;
    returns.fade(kFade);
    now.add(ranks);
    returns.add(now);
    mean = float(returns.mean(0));
    deviation = std::max(float(returns.deviation(0)), kMin);
  }
};

}  // namespace obby::train
