// The box around all positions of a moving part, for each of its colliders.
#pragma once

#include <cstddef>
#include <vector>

#include "level/level_view.h"

namespace obby::level {

// Reads a mover's tables once: a part can have thousands of hulls, and its keys tens of thousands
// of rows. If the product of both exceeds 2^24, neighbouring rows are merged, and the bounds become
// a little larger.
class SweptBounds {
 public:
  SweptBounds() = default;
  // `colliders` is the max number of the part's colliders.
  explicit SweptBounds(const Mover& mover, size_t colliders = 1);

  // Returns the box of a collider with these half extents. If the part spins, uses the max radius
  // about the pivot.
  Box of(Vec3 half) const;

 private:
  // Successive rows with one rotation. `places` bounds the positions of the point that the spin
  // leaves fixed. In merged runs `rotation` has the largest magnitude of each element instead.
  struct Run {
    Mat3 rotation;
    Box places;
  };
  void joinRuns(size_t limit);

  std::vector<Run> runs_;
  bool spins_ = false;
  float pivotAway_ = 0;  // studs from the part's centre
};

}  // namespace obby::level
