// Sums in a fixed order as kernels: chunks of rows, a chunk and column a thread, then the chunks.
#pragma once

#include "base/shuffle.h"
#include "train/device/product.h"
#include "train/parts.h"

namespace obby::train {

struct ColumnSumArguments {
  const float* rows;  // (count, width)
  double* sums;       // (chunks, width)
  uint32_t count, width;
};

// `sum` and the numbers of a column in rows `first` to `last` - 1, one after the other.
template <class Sum, class T>
OBBY_DEVICE Sum addColumn(Sum sum, const T* column, uint32_t first, uint32_t last, uint32_t width) {
#if defined(__CUDA_ARCH__)
#pragma unroll 16  // several numbers are on their way at once; the order stays
#endif
  for (uint32_t r = first; r < last; ++r) sum += Sum(column[size_t(r) * width]);
  return sum;
}

OBBY_DEVICE void sumColumnChunk(const ColumnSumArguments& s, uint32_t i) {
  const uint32_t chunk = i / s.width, column = i % s.width, first = chunk * kChunk;
  const uint32_t last = first + kChunk < s.count ? first + kChunk : s.count;
  s.sums[i] = addColumn(0.0, s.rows + column, first, last, s.width);
}

// Sums of several rows of numbers; of floats to a float, or of doubles to what was there.
struct RowSumArguments {
  const float* floats;    // (rows, width), or null
  const double* doubles;  // (rows, width), where `floats` is null
  float* out;             // (width), becomes the sum; or, of doubles, null
  double* added;          // (width), grows by the sum of doubles; or null
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

struct Moments {
  double sum, squares;
};

// Sum and sum of squares of parts of `values`, in their order or shuffled.
struct MomentArguments {
  const float* values;  // (rows of the parts)
  Moments* chunks;      // (parts, chunks of the largest)
  Moments* out;         // (parts)
  Shuffle shuffle;
  bool shuffled;
  Parts parts;

  OBBY_DEVICE uint32_t chunksOfEach() const { return chunksOf(parts.largest()); }
};

OBBY_DEVICE void momentsOfChunk(const MomentArguments& m, uint32_t i) {
  const uint32_t each = m.chunksOfEach(), part = i / each;
  const uint32_t first = m.parts.first(part) + i % each * kChunk;
  const uint32_t end = m.parts.first(part) + m.parts.size(part);
  Moments sums{0, 0};
  for (uint32_t k = first; k < end && k < first + kChunk; ++k) {
    const double v = double(m.values[m.shuffled ? m.shuffle(k) : k]);
    sums.sum += v;
    sums.squares += v * v;
  }
  m.chunks[i] = sums;
}

OBBY_DEVICE void momentsOfPart(const MomentArguments& m, uint32_t i) {
  const uint32_t each = m.chunksOfEach();
  Moments sums{0, 0};
  for (uint32_t c = i * each; c < (i + 1) * each; ++c) {
    sums.sum += m.chunks[c].sum;
    sums.squares += m.chunks[c].squares;
  }
  m.out[i] = sums;
}

}  // namespace obby::train
