// Boxes seen from above, and an index of many boxes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace obby::solve {

// Returns the horizontal distance between two boxes, in studs.
inline float gapBetween(const Box& a, const Box& b) {
  const float x = maxf(maxf(a.lo.x - b.hi.x, b.lo.x - a.hi.x), 0.0f);
  const float z = maxf(maxf(a.lo.z - b.hi.z, b.lo.z - a.hi.z), 0.0f);
  return sqrtf32(x * x + z * z);
}

// Returns the box as seen from above, grown by `more` on each side.
inline Box flat(const Box& box, float more) {
  return {{box.lo.x - more, 0, box.lo.z - more}, {box.hi.x + more, 0, box.hi.z + more}};
}

inline bool isWithin(const Box& inner, const Box& outer) {
  const Box all = join(inner, outer);
  return all.lo == outer.lo && all.hi == outer.hi;
}

// Returns a box that is neutral to join() and overlaps nothing.
inline Box noBox() { return {{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}}; }

// Finds which of many boxes overlap a given box.
class BoxIndex {
 public:
  explicit BoxIndex(const std::vector<Box>& boxes) {
    constexpr float kCell = 64;  // studs
    for (uint32_t i = 0; i < boxes.size(); ++i) items_.push_back({boxes[i], i});
    const auto key = [](const Item& item) {
      const Vec3 middle = (item.box.lo + item.box.hi) * (0.5f / kCell);
      return std::pair(std::floor(middle.x), middle.z);
    };
    std::stable_sort(items_.begin(), items_.end(),
                     [&](const Item& a, const Item& b) { return key(a) < key(b); });
    blocks_.assign((items_.size() + kBlock - 1) / kBlock, noBox());
    for (size_t i = 0; i < items_.size(); ++i) {
      blocks_[i / kBlock] = join(blocks_[i / kBlock], items_[i].box);
    }
  }

  // Calls test(i) once for each box that overlaps `box`, until one returns true. Returns true if
  // one did.
  template <class Test>
  bool any(const Box& box, Test&& test) const {
    for (size_t b = 0; b < blocks_.size(); ++b) {
      if (!overlaps(blocks_[b], box)) continue;
      const size_t end = std::min((b + 1) * kBlock, items_.size());
      for (size_t i = b * kBlock; i < end; ++i) {
        if (overlaps(items_[i].box, box) && test(items_[i].index)) return true;
      }
    }
    return false;
  }

 private:
  static constexpr size_t kBlock = 32;

  struct Item {
    Box box;
    uint32_t index;
  };

  std::vector<Item> items_;  // sorted so that neighbours are close
  std::vector<Box> blocks_;  // bounds of kBlock items each
};

}  // namespace obby::solve
