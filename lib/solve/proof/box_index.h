// Finds those of many boxes that meet another: a grid of wide cells, and a list of the boxes that
// are too large for it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace obby::solve {

class BoxIndex {
 public:
  explicit BoxIndex(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (uint32_t i = 0; i < boxes_.size(); ++i) {
      const Range range = rangeOf(boxes_[i]);
      if (range.count() > kMostCells) {
        large_.push_back(i);
      } else {
        forCells(range, [&](const Cell& cell) { cells_[keyOf(cell)].push_back(i); });
      }
    }
  }

  // Calls found(i) once for every box that meets `box`. Gives how many boxes it has looked at.
  template <class Found>
  size_t find(const Box& box, Found&& found) const {
    const Range range = rangeOf(box);
    size_t looked = large_.size();
    if (range.count() > kMostLooked) {
      for (uint32_t i = 0; i < boxes_.size(); ++i) {
        if (overlaps(boxes_[i], box)) found(i);
      }
      return boxes_.size();
    }
    for (const uint32_t i : large_) {
      if (overlaps(boxes_[i], box)) found(i);
    }
    forCells(range, [&](const Cell& cell) {
      const auto at = cells_.find(keyOf(cell));
      if (at == cells_.end()) return;
      looked += at->second.size();
      for (const uint32_t i : at->second) {
        // What is in several cells counts in the first that both are in.
        const bool first = cellOf(max(boxes_[i].lo, box.lo)) == cell;
        if (first && overlaps(boxes_[i], box)) found(i);
      }
    });
    return looked;
  }

 private:
  static constexpr float kCell = 32;         // studs
  static constexpr float kFarthest = 2e7f;   // studs from the origin; beyond: in the last cell
  static constexpr int64_t kMostCells = 64;  // of a box in the grid
  static constexpr int64_t kMostLooked = 4096;

  using Cell = std::array<int64_t, 3>;

  struct Range {
    Cell lo, hi;

    int64_t count() const {
      int64_t cells = 1;
      for (size_t a = 0; a < 3; ++a) {
        cells *= std::min(hi[a] - lo[a] + 1, kMostLooked + 1);
      }
      return cells;
    }
  };

  static int64_t along(float at) {
    return int64_t(std::floor(std::clamp(at, -kFarthest, kFarthest) / kCell));
  }
  static Cell cellOf(Vec3 at) { return {along(at.x), along(at.y), along(at.z)}; }
  static Range rangeOf(const Box& box) { return {cellOf(box.lo), cellOf(box.hi)}; }

  static uint64_t keyOf(const Cell& cell) {
    uint64_t key = 0;
    for (const int64_t c : cell) key = key << 21 | (uint64_t(c) & 0x1fffff);
    return key;
  }

  template <class Look>
  static void forCells(const Range& range, Look&& look) {
    Cell cell = range.lo;
    for (cell[2] = range.lo[2]; cell[2] <= range.hi[2]; ++cell[2]) {
      for (cell[1] = range.lo[1]; cell[1] <= range.hi[1]; ++cell[1]) {
        for (cell[0] = range.lo[0]; cell[0] <= range.hi[0]; ++cell[0]) look(cell);
      }
    }
  }

  std::vector<Box> boxes_;
  std::vector<uint32_t> large_;
  std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

}  // namespace obby::solve
