#include "nn/product.h"

#include <algorithm>
#include <type_traits>

#include "nn/unit_sums.h"

namespace obby::nn {

namespace {

// Columns whose sums are in registers at a time.
constexpr size_t kMaxUnits = std::min(size_t(64), 8 * size_t(kLanes));
constexpr float kZeros[4 * kColumns] = {};
static_assert(kColumns % kLanes == 0);

// Rows as they lie, for the functions of unit_sums.h.
template <class Inner>
struct WholeRows {
  const float* a;
  Inner inner;

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

// Calls visit(count), as a constant where it is a usual width.
template <class Visit>
void withWidth(size_t count, Visit&& visit) {
  if (count == 4 * kColumns) {
    visit(Constant<4 * kColumns>());
  } else if (count == 3 * kColumns) {
    visit(Constant<3 * kColumns>());
  } else {
    visit(count);
  }
}

// Calls block(first, how many as a constant) for all columns.
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

template <class Inner, class Columns>
void multiplyAs(const Product<float>& p, Inner inner, Columns columns) {
  WholeRows<Inner> rows{p.a, inner};
  forBlocks(columns, [&](size_t first, auto units) {
    const float* const unit = p.unit == nullptr ? nullptr : p.unit + first;
    multiplyUnits<int(units())>(rows, p.rows, inner, p.b + first, columns,
                                p.bias != nullptr ? p.bias + first : kZeros, p.out + first,
                                [&, rectified = p.rectified](size_t r, auto& sums) OBBY_INLINED {
                                  if (rectified) sums.rectify();
                                  if (unit != nullptr) sums.stopWhereOff(unit + r * columns);
                                });
  });
}

template <class Inner, class Columns>
void addGradientAs(const GradientProduct<float>& g, Inner inner, Columns columns) {
  forBlocks(columns, [&](size_t first, auto units) {
    for (size_t row = 0; row < g.rows; row += kRowBlock) {
      WholeRows<Inner> rows{g.a + row * inner, inner};
      addGradientUnits<int(units())>(rows, std::min(kRowBlock, g.rows - row), inner,
                                     g.b + row * columns + first, columns, g.sums + first);
    }
    UnitSums<int(units())> biases(g.biases + first);
    for (size_t r = 0; r < g.rows; ++r) biases.add(g.b + r * columns + first);
    biases.put(g.biases + first);
  });
}

}  // namespace

void multiply(const Product<float>& p) {
  withWidth(p.inner, [&](auto inner) {
    withWidth(p.columns, [&](auto columns) { multiplyAs(p, inner, columns); });
  });
}

void addGradient(const GradientProduct<float>& g) {
  withWidth(g.inner, [&](auto inner) {
    withWidth(g.columns, [&](auto columns) { addGradientAs(g, inner, columns); });
  });
}

}  // namespace obby::nn
