// May a player jump, as a query has it?
#pragma once

#include <cstdint>

#include "sim/next_region.h"
#include "solve/proof/solids.h"
#include "solve/proof/supports.h"

namespace obby::solve {

// What a touch does to a player at once: none of them jumps from then on.
constexpr uint32_t kLeads = level::kPad | level::kTeleport | level::kSeat;

// `unseen`: the query forbids the state, for which it looks after each tick, and a pad, a
// teleporter or a seat that is touched in the first tick of a jump has ended it by then.
enum class Jumping : uint8_t { never, unseen, free };

inline Jumping jumpingIn(const Problem& problem) {
  if (problem.query.maxJumps == 0) return Jumping::never;  // counts such a one too
  if (!sim::forbidsJumping(problem.query)) return Jumping::free;
  return (flagsOfAll(problem.level) & kLeads) != 0 ? Jumping::unseen : Jumping::never;
}

// Studs that a jump rises unseen, at most.
inline float unseenRise(const Problem& problem) {
  if (jumpingIn(problem) != Jumping::unseen) return 0;
  return fastestJump(problem.level) * problem.level.params.tickSeconds;
}

}  // namespace obby::solve
