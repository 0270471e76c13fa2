// How a part can move those on it and around it, over the whole of its motion.
#pragma once

#include <mutex>
#include <vector>

#include "level/level_view.h"
#include "solve/query/problem.h"

namespace obby::solve {

struct PartMotion {
  Box swept;           // all its places; of an upright block that turns, no cube
  float upward = 0;    // studs/s that it gives a player whom it carries or sets off
  float sideways = 0;  // the same; beyond walking
  float vertical = 0;  // studs/s up or down of any of its points
  float step = 0;      // studs that it moves in a tick, at most
};

PartMotion partMotion(const level::LevelView& level, uint32_t collider);

// (colliders)
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

inline std::vector<PartMotion> motionsOf(const Problem& problem) {
  return problem.motions != nullptr ? problem.motions->of(problem.level)
                                    : partMotions(problem.level);
}

}  // namespace obby::solve
