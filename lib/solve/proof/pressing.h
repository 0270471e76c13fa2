// What slides sideways can press a body into another part, tick by tick, until that part lifts it
// out over its top, or puts it out on its far side: how far below its top somebody can come onto it
// so, and where to.
//
// Parts that can have a body inside of them without its having come in (one that vanished is back)
// put it out likewise, into their neighbours. Where a third part is there, what it is put out of
// leads on into that: of such chains no more is known than that each part puts a body out by the
// shortest way.
#pragma once

#include <vector>

#include "solve/proof/part_motion.h"

namespace obby::solve {

// By collider.
struct Pressing {
  std::vector<float> depth;   // studs that the body can be in it, at most; 0: nothing presses
  std::vector<bool> presses;  // it moves, and presses against something
  std::vector<bool> chained;  // puts out at once, as far as it goes, whom others put into it
  std::vector<float> speed;   // studs/s at which it takes along whom it puts out; 0: nobody
  std::vector<Box> around;    // all of the body of those, where `speed` is above 0
};

// By collider: where all of the body of those is who can be inside of it without having come in.
using Holding = std::vector<std::vector<Box>>;

// `motions`: of all colliders that move.
Pressing pressingOf(const level::LevelView& level, const std::vector<PartMotion>& motions,
                    const Holding& holds);

}  // namespace obby::solve
