// Random numbers for tests of networks, and a check of gradients against finite differences.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"

namespace obby::nn {

// Returns numbers that are uniform between -1 and 1.
template <class S>
std::vector<S> drawn(size_t count, Random& random) {
  std::vector<S> v(count);
  for (S& x : v) x = S(2 * random.unit() - 1);
  return v;
}

// Compares sums of many numbers; the tolerance is relative to the largest.
template <class S>
void expectNear(const S* found, const S* expected, size_t count, double within, const char* what) {
  double largest = 0;
  for (size_t i = 0; i < count; ++i) largest = std::max(largest, std::abs(double(expected[i])));
  ASSERT_GT(largest, 0) << what;
  for (size_t i = 0; i < count; ++i)
    ASSERT_NEAR(double(found[i]), double(expected[i]), within * largest) << what << " " << i;
}

// Compares the gradient that loss(at, gradient) fills in with finite differences.
template <class Loss>
void checkGradient(std::vector<double> at, Loss&& loss, double within = 1e-6) {
  std::vector<double> gradient(at.size()), unused(at.size());
  loss(at.data(), gradient.data());
  for (size_t i = 0; i < at.size(); ++i) {
    const double step = 1e-6, old = at[i];
    at[i] = old + step;
    const double more = loss(at.data(), unused.data());
    at[i] = old - step;
    const double less = loss(at.data(), unused.data());
    at[i] = old;
    EXPECT_NEAR(gradient[i], (more - less) / (2 * step), within) << i;
  }
}

}  // namespace obby::nn
