// What slides sideways can press a body into another part, tick by tick, until that part lifts it
// out over its top: how far below its top somebody can come onto it so.
#pragma once

#include <vector>

#include "solve/proof/part_motion.h"

namespace obby::solve {

// By collider.
struct Pressing {
  std::vector<float> depth;   // studs that the body can be in it, at most; 0: nothing presses
  std::vector<bool> presses;  // it moves, and presses against something
};

// `motions`: of all colliders that move.
Pressing pressingOf(const level::LevelView& level, const std::vector<PartMotion>& motions);

}  // namespace obby::solve
