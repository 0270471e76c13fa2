// Matrix products as kernels. A thread computes one tile of the result, which limits the reads.
// Sums have a fixed order. Matrices are row-major; all widths are multiples of the tile width and
// of 4.
#pragma once

#include <stddef.h>

#include "math/lanes.h"

namespace obby::nn {

// Two ways to multiply. Each returns the same bits on a GPU and on the CPU.
struct Fused {  // fused multiply-add, for speed; gradients are summed in chunks of rows
  static constexpr int kTile = 8;
  // Measured on an H200: 128 rows learn 4 % faster than 256, and 2 % faster than 64.
  static constexpr uint32_t kGradientRows = 128;
  OBBY_DEVICE static float multiplyAdd(float a, float b, float sum) {
    return __builtin_fmaf(a, b, sum);
  }
};
struct AsCpu {  // has the bits of nn/pass.h
  static constexpr int kTile = 1;
  static constexpr uint32_t kGradientRows = 0x7fffffff;
  OBBY_DEVICE static float multiplyAdd(float a, float b, float sum) { return sum + a * b; }
};

// Neighbours in a row, which a GPU reads in one load.
template <int kCount>
struct alignas(kCount >= 4 ? 16 : 4) Run {
  float v[kCount];
};
template <int kCount>
OBBY_DEVICE const Run<kCount>& runAt(const float* numbers) {
  return *reinterpret_cast<const Run<kCount>*>(numbers);
}

// out = a x b + bias. Elements below 0 (if `rectified`) or with `unit` <= 0 become 0.
struct ProductArguments {
  const float* a;     // (rows, inner)
  const float* b;     // (inner, columns)
  const float* bias;  // (columns), or null
  const float* unit;  // (rows, columns), or null
  float* out;         // (rows, columns)
  uint32_t rows, inner, columns;
  bool rectified;
};

template <class Form>
OBBY_DEVICE uint32_t productTiles(const ProductArguments& p) {
  return (p.rows + Form::kTile - 1) / Form::kTile * (p.columns / Form::kTile);
}

// Sums of a tile, in registers on a GPU.
template <class Form>
struct Tile {
  static constexpr int kTile = Form::kTile;
  float v[kTile][kTile];

  OBBY_DEVICE explicit Tile(const float* row) {
    for (auto& sums : v) {
      for (int c = 0; c < kTile; ++c) sums[c] = row != nullptr ? row[c] : 0.0f;
    }
  }
  // Adds the outer product of a column of a and a row of b.
  OBBY_DEVICE void add(const float (&column)[kTile], const float* row) {
    const Run<kTile> values = runAt<kTile>(row);
    for (int r = 0; r < kTile; ++r) {
#if !defined(__CUDACC__)
#pragma GCC unroll 1  // a CPU then vectorises over the row
#endif
      for (int c = 0; c < kTile; ++c) v[r][c] = Form::multiplyAdd(column[r], values.v[c], v[r][c]);
    }
  }
};

template <class Form>
OBBY_DEVICE void productTile(const ProductArguments& p, uint32_t i) {
  constexpr int kTile = Form::kTile;
  const uint32_t across = p.columns / kTile;
  const uint32_t row = i / across * kTile, column = i % across * kTile;
  const float* rows[kTile];
  for (int r = 0; r < kTile; ++r) {  // rows past the end repeat the last; results are dropped
    const uint32_t at = row + uint32_t(r) < p.rows ? row + uint32_t(r) : p.rows - 1;
    rows[r] = p.a + size_t(at) * p.inner;
  }
  Tile<Form> sums(p.bias != nullptr ? p.bias + column : nullptr);
  for (uint32_t k = 0; k < p.inner; k += 4) {
    Run<4> a[kTile];
    for (int r = 0; r < kTile; ++r) a[r] = runAt<4>(rows[r] + k);
    for (int j = 0; j < 4; ++j) {
      float values[kTile];
      for (int r = 0; r < kTile; ++r) values[r] = a[r].v[j];
      sums.add(values, p.b + size_t(k + uint32_t(j)) * p.columns + column);
    }
  }
  for (int r = 0; r < kTile && row + uint32_t(r) < p.rows; ++r) {
    const size_t first = size_t(row + uint32_t(r)) * p.columns + column;
    for (int c = 0; c < kTile; ++c) {
      const float sum = sums.v[r][c];
      const bool off =
          (p.rectified && !(sum > 0)) || (p.unit != nullptr && !(p.unit[first + size_t(c)] > 0));
      p.out[first + size_t(c)] = off ? 0.0f : sum;
    }
  }
}

constexpr uint32_t kChunk = 256;  // rows that one thread sums

OBBY_DEVICE uint32_t chunksOf(uint32_t rows, uint32_t each = kChunk) {
  return rows / each + (rows % each != 0 ? 1 : 0);
}

// Products transposed(a) x b, summed over chunks of rows.
struct GradientArguments {
  const float* a;  // (rows, inner)
  const float* b;  // (rows, columns)
  float* sums;     // (chunks, inner, columns)
  uint32_t rows, inner, columns;
};

template <class Form>
OBBY_DEVICE uint32_t gradientTiles(const GradientArguments& g) {
  return g.inner / Form::kTile * (g.columns / Form::kTile) * chunksOf(g.rows, Form::kGradientRows);
}

template <class Form>
OBBY_DEVICE void gradientTile(const GradientArguments& g, uint32_t i) {
  constexpr int kTile = Form::kTile;
  const uint32_t across = g.columns / kTile, tiles = g.inner / kTile * across;
  const uint32_t chunk = i / tiles, tile = i % tiles;
  const uint32_t row = tile / across * kTile, column = tile % across * kTile;
  const uint32_t first = chunk * Form::kGradientRows;
  const uint32_t last = g.rows - first > Form::kGradientRows ? first + Form::kGradientRows : g.rows;
  Tile<Form> sums(nullptr);
#if defined(__CUDA_ARCH__)
#pragma unroll 4  // keeps several loads in flight; the order stays
#endif
  for (uint32_t r = first; r < last; ++r) {
    const Run<kTile> values = runAt<kTile>(g.a + size_t(r) * g.inner + row);
    sums.add(values.v, g.b + size_t(r) * g.columns + column);
  }
  float* const out = g.sums + size_t(chunk) * g.inner * g.columns;
  for (int r = 0; r < kTile; ++r) {
    for (int c = 0; c < kTile; ++c)
      out[size_t(row + uint32_t(r)) * g.columns + column + uint32_t(c)] = sums.v[r][c];
  }
}

// out = transposed(a).
struct TransposeArguments {
  const float* a;  // (rows, columns)
  float* out;
  uint32_t rows, columns;
};

OBBY_DEVICE void transposeOne(const TransposeArguments& t, uint32_t i) {
  t.out[size_t(i % t.columns) * t.rows + i / t.columns] = t.a[i];
}

}  // namespace obby::nn
