// How far a jump may move a player at once: as it begins the torso does not collide, and who is in
// a low part by then is put out of it, on its far side too.
//
// Where the head passes over all of a part but its top, no more of the body is in it than the torso
// is high, and no more than the top is above the hips. Each of several parts near each other may
// put out whom another has put out; through thin ones that leads on without a bound.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"

namespace obby::solve {

struct PutOut {
  float away;     // studs that somebody has come by before, at least
  float studs;    // at most; infinite: no bound is known
  float seconds;  // until the jump after that may end so too, at least
};

// What somebody may jump from.
struct Footing {
  uint32_t collider;
  float highest;  // the top of no part that the head passes over is higher
};

// What is known of all players.
struct Moves {
  Vec3 start;   // feet
  float apex;   // highest that feet come
  float speed;  // fastest sideways, studs/s
};

// In no order.
std::vector<PutOut> putOutsOf(const level::LevelView& level, const std::vector<Footing>& floors,
                              const Moves& moves);

// That so many studs take at least, at `speed` and with any of these. `mostJumps`: -1: any.
float secondsFor(float studs, float speed, std::vector<PutOut> outs, int32_t mostJumps);

}  // namespace obby::solve
