// The product of matrices that learning on the CPU runs on. Each number is summed in the order
// of the inner index, whatever the lanes, so that it has the same bits on every machine. Host only.
#pragma once

#include <cstddef>
#include <experimental/simd>

namespace obby::nn {

constexpr size_t kColumns = 16;  // the columns of every matrix are a multiple of this

// A matrix or its transpose: the number at (row, inner) is at[row * rowStep + inner * step].
template <class S>
struct Factor {
  const S* at;
  size_t rowStep, step;
};

template <size_t kRows, class S>
void addRows(const Factor<S>& a, size_t inner, const S* b, size_t columns, S* c) {
  using Lanes = std::experimental::native_simd<S>;
  constexpr auto kAnywhere = std::experimental::element_aligned;
  static_assert(kColumns % Lanes::size() == 0);
  for (size_t first = 0; first < columns; first += Lanes::size()) {
    Lanes sums[kRows];
    for (size_t r = 0; r < kRows; ++r) sums[r].copy_from(c + r * columns + first, kAnywhere);
    for (size_t k = 0; k < inner; ++k) {
      const Lanes row(b + k * columns + first, kAnywhere);
#pragma GCC unroll 8
      for (size_t r = 0; r < kRows; ++r)
        sums[r] = sums[r] + Lanes(a.at[r * a.rowStep + k * a.step]) * row;
    }
    for (size_t r = 0; r < kRows; ++r) sums[r].copy_to(c + r * columns + first, kAnywhere);
  }
}

// c += a b, with `a` (rows, inner), `b` (inner, columns), `c` (rows, columns).
template <class S>
void addProduct(Factor<S> a, size_t rows, size_t inner, const S* b, size_t columns, S* c) {
  constexpr size_t kSome = 8;
  for (; rows >= kSome; rows -= kSome) {
    addRows<kSome>(a, inner, b, columns, c);
    a.at += kSome * a.rowStep;
    c += kSome * columns;
  }
  for (; rows > 0; --rows) {
    addRows<1>(a, inner, b, columns, c);
    a.at += a.rowStep;
    c += columns;
  }
}

}  // namespace obby::nn
