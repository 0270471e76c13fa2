// Sums in a fixed order as kernels. A thread sums one column of a chunk of rows; another kernel
// sums the chunks.
#pragma once

#include "base/shuffle.h"
#include "nn/advantages.h"
#include "nn/device/product.h"
#include "nn/minibatches.h"

namespace obby::nn {

struct ColumnSumArguments {
  const float* rows;  // (count, width)
  double* sums;       // (chunks, width)
  uint32_t count, width;
};

// Returns `sum` plus the numbers of a column in rows [first, last), added in order.
template <class Sum, class T>
OBBY_DEVICE Sum addColumn(Sum sum, const T* column, uint32_t first, uint32_t last, uint32_t width) {
#if defined(__CUDA_ARCH__)
#pragma unroll 16  // keeps several loads in flight; the order stays
#endif
  for (uint32_t r = first; r < last; ++r) sum += Sum(column[size_t(r) * width]);
  return sum;
}

OBBY_DEVICE void sumColumnChunk(const ColumnSumArguments& s, uint32_t i) {
  const uint32_t chunk = i / s.width, column = i % s.width, first = chunk * kChunk;
  const uint32_t last = first + kChunk < s.count ? first + kChunk : s.count;
  s.sums[i] = addColumn(0.0, s.rows + column, first, last, s.width);
}

// Sums rows of floats into `out`, or of doubles into `out`, `added` or both.
struct RowSumArguments {
  const float* floats;    // (rows, width), or null
  const double* doubles;  // (rows, width), used if `floats` is null
  float* out;             // (width), overwritten; null if only `added` is wanted
  double* added;          // (width), the sum of doubles is added; or null
  uint32_t rows, width;   // both at least 1
};

OBBY_DEVICE void sumRows(const RowSumArguments& s, uint32_t i) {
  if (s.floats != nullptr) {
    s.out[i] = addColumn(s.floats[i], s.floats + i, 1, s.rows, s.width);
    return;
  }
  const double sum = addColumn(0.0, s.doubles + i, 0, s.rows, s.width);
  if (s.out != nullptr) s.out[i] = float(sum);
  if (s.added != nullptr) s.added[i] += sum;
}

// Moments of `values` in each minibatch, in order or shuffled.
struct MomentArguments {
  const float* values;  // (rows)
  Moments* chunks;      // (minibatches, chunks of the largest)
  Moments* out;         // (minibatches)
  Shuffle shuffle;
  bool shuffled;
  Minibatches minibatches;

  OBBY_DEVICE uint32_t chunksOfEach() const { return chunksOf(minibatches.largest()); }
};

OBBY_DEVICE void momentsOfChunk(const MomentArguments& m, uint32_t i) {
  const uint32_t each = m.chunksOfEach(), minibatch = i / each;
  const uint32_t begin = m.minibatches.first(minibatch), first = begin + i % each * kChunk;
  const uint32_t end = begin + m.minibatches.size(minibatch);
  Moments sums;
  for (uint32_t k = first; k < end && k < first + kChunk; ++k)
    sums.add(double(m.values[m.shuffled ? m.shuffle(k) : k]));
  m.chunks[i] = sums;
}

OBBY_DEVICE void momentsOfMinibatch(const MomentArguments& m, uint32_t i) {
  const uint32_t each = m.chunksOfEach();
  Moments sums;
  for (uint32_t c = i * each; c < (i + 1) * each; ++c) sums.add(m.chunks[c]);
  m.out[i] = sums;
}

}  // namespace obby::nn
