// Supports are everything that can carry or launch a player: colliders, the start, and the ends of
// teleporters. The bound on reach uses them (reach_bound.h). Boxes and speeds are upper bounds.
#pragma once

#include <vector>

#include "solve/proof/body_limits.h"
#include "solve/proof/boxes.h"

namespace obby::solve {

// The relation of a body to a part next to it (docs/proof.md, Contacts).
enum class Beside : uint8_t {
  clear,    // the body is pushed out within a substep: the part is entered only from above
  pinched,  // another part may hold the body in place: a jump may lead it into low parts
  deep,     // the body may be anywhere inside the part, and leaves it anywhere
};

struct Support {
  Box box;           // bounds of the part over its motion; its top is level unless `wild`
  float lowest = 0;  // min height of the top, or of feet next to the part if the top is not level
  float entry = 1e30f;  // min height of feet that enter it, in a jump
  float side = 0;       // radius around the box in which it is entered and left
  float stand = 0;      // radius around the box in which a jump can begin
  float lift = 0;       // max studs of feet at rest above the top
  float takeOff = 0;    // max studs of a take-off above `lift`
  float upward = 0;     // studs/s that it adds to a jump
  float rising = 0;     // studs/s upward of a player in Running on it
  float toss = 0;       // studs/s upward that it gives without a jump
  float vertical = 0;   // max studs/s up or down; huge: it changes place at once
  float sideways = 0;   // studs/s that it gives beyond walking
  float pushes = 0;     // studs/s by which it moves players next to it
  Beside beside = Beside::clear;
  bool carries = false;              // false: players only appear there, or are launched
  bool wild = false;                 // nothing is known of what it does to a player
  uint32_t collider = level::kNone;  // kNone: the start, or the end of a teleporter
  uint32_t leadsTo = level::kNone;   // the support that touching it leads to

  float top() const { return box.hi.y; }
};

// Returns true if the collider is upright and along the axes of the world, as its bounds are.
bool isAxial(const level::LevelView& level, uint32_t collider);

// Returns the start, then the ends of teleporters, then each collider that has an effect.
std::vector<Support> supportsOf(const Problem& problem, const BodyLimits& limits,
                                const std::vector<PartMotion>& motions);

}  // namespace obby::solve
