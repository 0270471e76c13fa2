#include "nn/product.h"

#include <algorithm>
#include <type_traits>

#include "nn/unit_sums.h"

namespace obby::nn {

namespace {

// Max number of columns whose sums are in registers at the same time.
constexpr size_t kMaxUnits = std::min(size_t(64), 8 * size_t(kLanes));
constexpr float kZeros[4 * kColumns] = {};
static_assert(kColumns % kLanes == 0);

// Dense rows, for the functions of unit_sums.h.
struct WholeRows {
  const float* a;
  size_t inner;

  OBBY_LANES uint64_t bits(size_t r, size_t w) const {
    return nonZero(a + r * inner + w * kWord, std::min<size_t>(kWord, inner - w * kWord));
  }
  OBBY_LANES auto cursor(size_t r, size_t w) const {
    return [row = a + r * inner + w * kWord](int bit) OBBY_INLINED { return row[bit]; };
  }
  template <class Cursor>
  OBBY_LANES void end(size_t, const Cursor&) const {}
  OBBY_LANES float value(size_t r, size_t w, int bit) const {
    return a[r * inner + w * kWord + size_t(bit)];
  }
};

template <size_t kCount>
using Constant = std::integral_constant<size_t, kCount>;

// Calls block(first, width) for all columns. The width is a std::integral_constant.
template <class Block>
void forBlocks(size_t columns, Block&& block) {
  size_t first = 0;
  for (; first + kMaxUnits <= columns; first += kMaxUnits) block(first, Constant<kMaxUnits>());
  switch ((columns - first) / kColumns) {
    case 3: return block(first, Constant<3 * kColumns>());
    case 2: return block(first, Constant<2 * kColumns>());
    case 1: return block(first, Constant<kColumns>());
    default: return;
  }
}

}  // namespace

void multiply(const Product<float>& p) {
  WholeRows rows{p.a, p.inner};
  forBlocks(p.columns, [&](size_t first, auto units) {
    const float* const unit = p.unit == nullptr ? nullptr : p.unit + first;
    multiplyUnits<int(units())>(rows, p.rows, p.inner, p.b + first, p.columns,
                                p.bias != nullptr ? p.bias + first : kZeros, p.out + first,
                                [&](size_t r, auto& sums) OBBY_INLINED {
                                  if (p.rectified) sums.rectify();
                                  if (unit != nullptr) sums.stopWhereOff(unit + r * p.columns);
                                });
  });
}

void addGradient(const GradientProduct<float>& g) {
  forBlocks(g.columns, [&](size_t first, auto units) {
    for (size_t row = 0; row < g.rows; row += kRowBlock) {
      WholeRows rows{g.a + row * g.inner, g.inner};
      addGradientUnits<int(units())>(rows, std::min(kRowBlock, g.rows - row), g.inner,
                                     g.b + row * g.columns + first, g.columns, g.sums + first);
    }
    UnitSums<int(units())> biases(g.biases + first);
    for (size_t r = 0; r < g.rows; ++r) biases.add(g.b + r * g.columns + first);
    biases.put(g.biases + first);
  });
}

}  // namespace obby::nn
