// The box around all places where a moving part comes, for each of its colliders.
#pragma once

#include <vector>

#include "level/level_view.h"

namespace obby::level {

// Reads a mover's tables once: a part can have thousands of hulls, and its keys tens of thousands
// of rows.
class SweptBounds {
 public:
  SweptBounds() = default;
  explicit SweptBounds(const Mover& mover);

  // Of a collider with these half extents; where it spins, with the largest radius about the pivot.
  Box of(Vec3 half) const;

 private:
  // Where rows with one rotation, one after the other, have what stays in place under the spin.
  struct Run {
    Mat3 rotation;
    Box places;
  };
  std::vector<Run> runs_;
  bool spins_ = false;
  float pivotAway_ = 0;  // studs from the part's centre
};

}  // namespace obby::level
