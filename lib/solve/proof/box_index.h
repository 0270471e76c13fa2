// Finds those of many boxes that meet another: blocks of boxes that are near each other, seen from
// above.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace obby::solve {

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
    for (size_t i = 0; i < items_.size(); ++i) {
      if (i % kBlock == 0) blocks_.push_back(items_[i].box);
      blocks_.back() = join(blocks_.back(), items_[i].box);
    }
  }

  // Calls found(i) once for every box that meets `box`.
  template <class Found>
  void find(const Box& box, Found&& found) const {
    findWhile(box, [&](uint32_t i) {
      found(i);
      return true;
    });
  }

  // The same until found(i) returns false.
  template <class Found>
  void findWhile(const Box& box, Found&& found) const {
    for (size_t b = 0; b < blocks_.size(); ++b) {
      if (!overlaps(blocks_[b], box)) continue;
      const size_t end = std::min((b + 1) * kBlock, items_.size());
      for (size_t i = b * kBlock; i < end; ++i) {
        if (overlaps(items_[i].box, box) && !found(items_[i].index)) return;
      }
    }
  }

 private:
  static constexpr size_t kBlock = 32;

  struct Item {
    Box box;
    uint32_t index;
  };

  std::vector<Item> items_;
  std::vector<Box> blocks_;  // of so many items each
};

}  // namespace obby::solve
