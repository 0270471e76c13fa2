// Describes in words for which players an answer holds.
#pragma once

#include <string>
#include <vector>

#include "schema/obby.capnp.h"

namespace obby::solve {

struct PlayerVerdict {
  std::string body;  // empty: the level's physics
  uint32_t rate;     // frames per second
  schema::Verdict verdict;
};

// Returns text like "Solved for R6 and R15 at 60 frames a second; unreachable for R15 at 30 frames
// a second." Without `namesBodies` the text names only the frame rates.
std::string playersText(const std::vector<PlayerVerdict>& players, bool namesBodies);
// Describes a search for keys that solve the query for all players.
std::string sameKeysText(const std::vector<PlayerVerdict>& players, bool namesBodies);
// Returns text like "R15 at 30 frames a second".
std::string playerText(const PlayerVerdict& player, bool namesBodies);

}  // namespace obby::solve
