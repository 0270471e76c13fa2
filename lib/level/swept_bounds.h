// The box around all places where a moving part comes, for each of its colliders.
#pragma once

#include <cstddef>
#include <vector>

#include "level/level_view.h"

namespace obby::level {

// Reads a mover's tables once: a part can have thousands of hulls, and its keys tens of thousands
// of rows. Where both together are too many (2^24), neighbouring rows are taken as one that reaches
// wherever one of them does: bounds are a little larger then.
class SweptBounds {
 public:
  SweptBounds() = default;
  // `colliders`: how many the part may have.
  explicit SweptBounds(const Mover& mover, size_t colliders = 1);

  // Of a collider with these half extents; where it spins, with the largest radius about the pivot.
  Box of(Vec3 half) const;

 private:
  // Where rows with one rotation, one after the other, have what stays in place under the spin.
  // Of rows that were joined it is no rotation, but the largest of all their numbers.
  struct Run {
    Mat3 rotation;
    Box places;
  };
  void joinRuns(size_t most);

  std::vector<Run> runs_;
  bool spins_ = false;
  float pivotAway_ = 0;  // studs from the part's centre
};

}  // namespace obby::level
