// Matrix products for learning on the CPU. Each sum follows the inner index, unfused, so that its
// bits are the same for any lane width. Zeros of the left matrix are skipped: about half of the
// rectified units are zero. Host only.
#pragma once

#include <cstddef>

namespace obby::nn {

constexpr size_t kColumns = 16;  // the columns of every matrix are a multiple of this

// out = a x b + bias. Elements below 0 (if `rectified`) or with `unit` <= 0 become 0.
template <class S>
struct Product {
  const S* a;     // (rows, inner)
  const S* b;     // (inner, columns)
  const S* bias;  // (columns), or null
  const S* unit;  // (rows, columns), or null
  S* out;         // (rows, columns)
  size_t rows, inner, columns;
  bool rectified;
};
void multiply(const Product<float>& p);

// sums += transposed(a) x b, and biases += the sum of b's rows.
template <class S>
struct GradientProduct {
  const S* a;  // (rows, inner)
  const S* b;  // (rows, columns)
  S* sums;     // (inner, columns)
  S* biases;   // (columns)
  size_t rows, inner, columns;
};
void addGradient(const GradientProduct<float>& g);

// Reference implementations, for tests in double precision.
template <class S>
void multiply(const Product<S>& p) {
  for (size_t r = 0; r < p.rows; ++r) {
    for (size_t c = 0; c < p.columns; ++c) {
      S sum = p.bias != nullptr ? p.bias[c] : S(0);
      for (size_t k = 0; k < p.inner; ++k) sum += p.a[r * p.inner + k] * p.b[k * p.columns + c];
      const size_t at = r * p.columns + c;
      const bool off = (p.rectified && !(sum > 0)) || (p.unit != nullptr && !(p.unit[at] > 0));
      p.out[at] = off ? S(0) : sum;
    }
  }
}

template <class S>
void addGradient(const GradientProduct<S>& g) {
  for (size_t r = 0; r < g.rows; ++r) {
    for (size_t c = 0; c < g.columns; ++c) {
      const S b = g.b[r * g.columns + c];
      for (size_t k = 0; k < g.inner; ++k) g.sums[k * g.columns + c] += g.a[r * g.inner + k] * b;
      g.biases[c] += b;
    }
  }
}

}  // namespace obby::nn
