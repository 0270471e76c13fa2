// Tests a box against a part's bounds in one comparison of eight numbers. Host only.
#pragma once

#include <experimental/simd>

#include "level/level_view.h"

namespace obby::sim {

// The corners of a box in the layout of level::Bounds, and two numbers that are never exceeded.
class Reach {
  using Eight = std::experimental::simd<float, std::experimental::simd_abi::deduce_t<float, 8>>;

 public:
  static constexpr float kAny = 1e38f;

  explicit Reach(const float* row) : row_(row, std::experimental::element_aligned) {}
  explicit Reach(const Box& box, float last = kAny) {
    const float row[8] = {box.hi.x,  box.hi.y,  box.hi.z, -box.lo.x,
                          -box.lo.y, -box.lo.z, last,     last};
    row_.copy_from(row, std::experimental::element_aligned);
  }

  // Subtracting the result moves the four sides of a box inward by `studs`.
  static Reach sides(float studs) { return Reach(Box{{-studs, 0, -studs}, {studs, 0, studs}}, 0); }
  Reach operator-(const Reach& by) const {
    Reach out = *this;
    out.row_ -= by.row_;
    return out;
  }

  // Returns 1 or 0, so that callers need not branch.
  uint32_t meets(const level::Bounds& b) const {
    return all_of(Eight(&b.lo.x, std::experimental::element_aligned) <= row_) ? 1 : 0;
  }

 private:
  Eight row_;
};

}  // namespace obby::sim
