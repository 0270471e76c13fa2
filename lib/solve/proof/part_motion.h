// How a part can move those on it and around it, over the whole of its motion.
#pragma once

#include <vector>

#include "level/level_view.h"

namespace obby::solve {

struct PartMotion {
  Box swept;           // all its places; of an upright block that turns, no cube
  float upward = 0;    // studs/s that it gives a player whom it carries or sets off
  float sideways = 0;  // the same; beyond walking
  float vertical = 0;  // studs/s up or down of any of its points
  float step = 0;      // studs that it moves in a tick, at most
};

// (colliders)
std::vector<PartMotion> partMotions(const level::LevelView& level);

}  // namespace obby::solve
