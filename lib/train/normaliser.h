// Mean and spread of a stream of rows, as far as it has come.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "train/ranks.h"

namespace obby::train {

// Sums of some rows; added up in a fixed order they give the same bits whoever made them.
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
  // Those of all ranks, in their order.
  void add(Ranks& ranks) {
    ranks.add(sum);
    ranks.add(squares);
    ranks.add({&rows, 1});
  }
  // What was counted so far counts a share only from now on.
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

// What an input is multiplied by. What hardly ever changes is not blown up.
constexpr float kLeastDeviation = 0.02f;
inline float scaleOf(double deviation) { return 1 / std::max(float(deviation), kLeastDeviation); }

}  // namespace obby::train
