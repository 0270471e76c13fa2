// Upper bounds on how a part can move players on it and around it, over its whole motion.
#pragma once

#include <vector>

#include "level/level_view.h"

namespace obby::solve {

struct PartMotion {
  Box swept;           // bounds of the part over its whole motion, tight in height if it is upright
  float upward = 0;    // upward studs/s given to a player that it carries or launches
  float sideways = 0;  // sideways studs/s given to that player, beyond walking
  float vertical = 0;  // max vertical studs/s of any of its points
  float step = 0;      // max studs that it moves in a tick
};

// Returns the motion of each collider: (colliders).
std::vector<PartMotion> partMotions(const level::LevelView& level);

}  // namespace obby::solve
