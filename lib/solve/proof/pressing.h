// What slides sideways can press a body into another part, tick by tick, until that part lifts it
// out over its top, or puts it out on its far side: how far below its top somebody can come onto it
// so, and where to.
//
// Parts that can have a body inside of them without its having come in (one that vanished is back)
// put it out likewise, into their neighbours. Where a third part is there, what it is put out of
// leads on into that: of such chains no more is known than that each part puts a body out by the
// shortest way. So do low parts whom somebody may be in as a jump begins, through what is thin
// (pass_through.h).
#pragma once

#include <limits>
#include <vector>

#include "solve/proof/part_motion.h"

namespace obby::solve {

constexpr float kAtOnce = std::numeric_limits<float>::infinity();  // studs/s

// By collider.
struct Pressing {
  std::vector<float> depth;   // studs that the body can be in it, at most; 0: nothing presses
  std::vector<bool> presses;  // it moves, and presses against something
  // Something is pressed between its side and another's: out of the wedge that the two make at the
  // speed at which they close over the sine of its angle, as far as it goes.
  std::vector<bool> bursts;
  std::vector<bool> chained;  // puts out at once, as far as it goes, whom others put into it
  std::vector<float> speed;   // studs/s at which it takes along whom it puts out; 0: nobody
  std::vector<Box> around;    // all of the body of those, where `speed` is above 0

  // The part takes along whom it puts out, at so many studs/s, within `where`.
  void noteAround(uint32_t part, float takes, const Box& where) {
    around[part] = speed[part] > 0 ? join(around[part], where) : where;
    speed[part] = speed[part] > takes ? speed[part] : takes;
  }
};

// By collider: where all of the body of those is who can be inside of it without having come in.
using Holding = std::vector<std::vector<Box>>;

// `motions`: of all colliders that move. `mayJump`: players may.
Pressing pressingOf(const level::LevelView& level, const std::vector<PartMotion>& motions,
                    const Holding& holds, bool mayJump);

}  // namespace obby::solve
