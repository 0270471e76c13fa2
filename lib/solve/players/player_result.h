// One result record of the answers for several players.
#pragma once

#include <vector>

#include "solve/players/player_case.h"

namespace obby::solve {

// Solved if it is for all of them, unreachable if it is for one of them, else unknown.
schema::Verdict verdictOf(const std::vector<PlayerCase>& cases);

struct PlayersAsked {
  uint32_t levelRate;  // ticks per second, in which the result counts
  bool namesBodies;
  bool sameKeys;
};

// Fields that hold one value describe the player who decides the verdict.
io::Record resultOf(const std::vector<PlayerCase>& cases, const PlayersAsked& asked);

}  // namespace obby::solve
