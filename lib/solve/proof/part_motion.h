// What a moving part does to those around it, over the whole of its motion.
#pragma once

#include <mutex>
#include <vector>

#include "level/level_view.h"

namespace obby::solve {

struct PartMotion {
  uint32_t collider = level::kNone;
  float upward = 0, sideways = 0;  // fastest of any of its points, studs/s
  float lowestTop = 0;             // of an upright block: its top at its lowest
  Box swept;           // where it can be; of what turns upright as high as it is, no cube
  bool rough = false;  // turns over, rises, or jumps: may push a player through other parts
};

// Of a collider that has a mover.
PartMotion partMotion(const level::LevelView& level, uint32_t collider);

// Of all colliders that move, in their order.
std::vector<PartMotion> partMotions(const level::LevelView& level);

// The same for one level, worked out when it is first asked for: each hull of a part looks at all
// keys. Safe to share between threads.
class PartMotions {
 public:
  // Always the same level.
  const std::vector<PartMotion>& of(const level::LevelView& level) const {
    std::call_once(once_, [&] { motions_ = partMotions(level); });
    return motions_;
  }

 private:
  mutable std::once_flag once_;
  mutable std::vector<PartMotion> motions_;
};

}  // namespace obby::solve
