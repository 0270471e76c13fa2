// Which colliders a part has: they follow one another in the level's table.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"

namespace obby::level {

struct ColliderRun {
  uint32_t first = 0, count = 0;  // of LevelView::colliders; count 0: it has none
};

// Of all parts, found in one pass.
class ColliderRuns {
 public:
  explicit ColliderRuns(const LevelView& level) {
    for (uint32_t i = 0; i < level.colliderCount; ++i) {
      const uint32_t part = level.colliders[i].part;
      if (part >= runs_.size()) runs_.resize(size_t(part) + 1);
      if (runs_[part].count++ == 0) runs_[part].first = i;
    }
  }

  ColliderRun of(uint32_t part) const { return part < runs_.size() ? runs_[part] : ColliderRun{}; }

 private:
  std::vector<ColliderRun> runs_;  // by part, up to the last one that has any
};

}  // namespace obby::level
