// How a moving part can move those around it, over the whole of its motion.
#pragma once

#include <mutex>
#include <vector>

#include "level/level_view.h"

namespace obby::solve {

struct PartMotion {
  uint32_t collider = level::kNone;
  Box swept;           // all its places; of an upright block that turns, no cube
  float upward = 0;    // fastest of any of its points, studs/s, and of a player whom it carries
  float vertical = 0;  // up or down
  float sideways = 0;
  float step = 0;  // studs that it moves in a tick, at most
};

// Of a collider that has a mover.
PartMotion partMotion(const level::LevelView& level, uint32_t collider);

// Of all colliders that move, in their order.
std::vector<PartMotion> partMotions(const level::LevelView& level);

// The same for one level, computed when first asked for: each hull of a part looks at all keys.
// Safe to share between threads.
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
