// What can carry a player or set one off: every collider as the bound on reach sees it
// (reach_bound.h). Boxes and speeds are upper bounds.
#pragma once

#include <vector>

#include "solve/proof/body_limits.h"
#include "solve/proof/boxes.h"

namespace obby::solve {

// How much is known of a body beside a part (docs/proof.md, contacts).
enum class Beside : uint8_t {
  clear,    // pushed out within a substep: the part is entered from above only
  pinched,  // another part may hold the body in place: a jump may lead it into low parts
  deep,     // it may be anywhere inside, and leaves anywhere around the part
};

struct Support {
  Box box;              // where the part can be; its top is level unless `wild`
  float lowest = 0;     // of the top; of feet beside it where that is not level
  float entry = 1e30f;  // feet at least this high come to be carried, in a jump
  float side = 0;       // radius around the box in which it is entered and left
  float stand = 0;      // radius around the box in which a jump can begin
  float lift = 0;       // studs above the top that the feet can be at rest
  float takeOff = 0;    // studs above that, where parts around stop a fall or a jump
  float upward = 0;     // studs/s that a jump from it has on top
  float rising = 0;     // studs/s upward of a player in Running on it
  float toss = 0;       // studs/s upward that it gives without a jump
  float vertical = 0;   // studs/s that it goes up or down, at most; huge: by leaps
  float sideways = 0;   // studs/s that it gives beyond walking
  float pushes = 0;     // studs/s by which it moves players who are beside it
  Beside beside = Beside::clear;
  bool carries = false;              // not: the player only appears there, or is sent off
  bool wild = false;                 // nothing is known of what it does
  uint32_t collider = level::kNone;  // none: the start, or where a teleporter leads
  uint32_t leadsTo = level::kNone;   // support that touching it leads to

  float top() const { return box.hi.y; }
};

// Is it upright and along the axes of the world, as its bounds are?
bool isAxial(const level::LevelView& level, uint32_t collider);

// The start first, then where teleporters lead, then each collider that does anything.
std::vector<Support> supportsOf(const Problem& problem, const BodyLimits& limits,
                                const std::vector<PartMotion>& motions);

}  // namespace obby::solve
