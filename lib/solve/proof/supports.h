// What can carry a player or set one off: every collider as the bound on reach sees it
// (reach_bound.h). All boxes are of feet, and larger than the truth.
#pragma once

#include <vector>

#include "solve/query/problem.h"

namespace obby::solve {

constexpr float kSteepSpeed = 4;    // studs/s gained on faces steeper than any slope limit
constexpr float kFeetSpare = 1.5f;  // studs that the feet of two supports reach beyond the truth

struct Support {
  Box feet;                          // where the feet can be while it carries; hi.y: at the highest
  float entry = 0;                   // feet at least this high come to be carried
  float top = 0;                     // of the part
  float upward = 0;                  // studs/s at which it lifts; a jump adds to it
  float thrown = 0;                  // studs/s at which it lets go without a jump
  float sprung = 0;                  // likewise, off the springs of legs on a floor that rises
  float down = 0;                    // studs/s downward at which it lets go
  float sideways = 0;                // studs/s that it gives, beside walking
  float pushes = 0;                  // studs/s at which it moves who is in its way, at most
  Box pushed;                        // where those are meanwhile
  bool carries = false;              // not: only leads elsewhere
  bool snaps = false;                // may move the player some studs at once
  bool bursts = false;               // may move those much faster than that within `pushed`
  bool tilted = false;               // has slopes, which turn speed upward
  bool keepsSpeed = false;           // who appears there has the speed that slopes may have given
  uint32_t collider = level::kNone;  // none: the start, or where a teleporter leads
  uint32_t leadsTo = level::kNone;   // support that touching it leads to
};

// The start first, then where teleporters lead, then each collider that does anything.
std::vector<Support> supportsOf(const Problem& problem);

// What of the level no bound is known for, in words; null: there is nothing of the kind.
const char* unboundedPart(const level::LevelView& level);

// Fastest walk, and launch speed of a jump, under all boosts of the level, studs/s.
float fastestWalk(const level::LevelView& level);
float fastestJump(const level::LevelView& level);
// Likewise of a climb; 0: there is no truss.
float fastestClimb(const level::LevelView& level);
// Launch speed of a jump under the boost that is worst for it, studs/s.
float slowestJump(const level::LevelView& level);

// Can a player fall down, without legs and keys?
bool anyHelpless(const level::LevelView& level);

}  // namespace obby::solve
