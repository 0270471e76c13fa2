// Combines the answers for several players into one result record.
#pragma once

#include <vector>

#include "solve/players/player_case.h"

namespace obby::solve {

// Returns solved if all cases are solved, unreachable if one is unreachable, and unknown otherwise.
schema::Verdict verdictOf(const std::vector<PlayerCase>& cases);

// How the solutions of several players belong together.
enum class PlayersKeys : uint8_t {
  own,     // each player presses other keys
  shared,  // one solution's keys, held by time, work for all
  asked,   // the query asks for such keys
};

struct PlayersAsked {
  uint32_t levelRate;  // ticks per second of the result's times
  bool namesBodies;
  PlayersKeys keys;
};

// Returns the combined result. Fields that hold one value are those of the player that decides the
// verdict.
io::Record resultOf(const std::vector<PlayerCase>& cases, const PlayersAsked& asked);

}  // namespace obby::solve
