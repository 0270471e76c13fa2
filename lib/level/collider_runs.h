// The colliders of each part, which follow one another in the level's table.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"

namespace obby::level {

struct ColliderRun {
  uint32_t first = 0, count = 0;  // indices into LevelView::colliders; count 0 for none
};

// The runs of all parts, found in one pass at the first request.
class ColliderRuns {
 public:
  // The level must outlive this object.
  explicit ColliderRuns(const LevelView& level) : level_(level) {}

  ColliderRun of(uint32_t part) {
    if (runs_.empty()) find();
    return part < runs_.size() ? runs_[part] : ColliderRun{};
  }

 private:
  void find() {
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      const uint32_t part = level_.colliders[i].part;
      if (part >= runs_.size()) runs_.resize(size_t(part) + 1);
      if (runs_[part].count++ == 0) runs_[part].first = i;
    }
  }

  const LevelView& level_;
  std::vector<ColliderRun> runs_;  // one for each part, up to the last part that has colliders
};

}  // namespace obby::level
