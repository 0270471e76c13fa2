// For which players an answer holds, in words.
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

// "Solved for R6 and R15 at 60 frames a second; nobody can with R15 at 30 frames a second."
// `namesBodies`: else the frame rates alone are named.
std::string playersText(const std::vector<PlayerVerdict>& players, bool namesBodies);
// The same for a search for keys that do for all of them.
std::string sameKeysText(const std::vector<PlayerVerdict>& players, bool namesBodies);
// "R15 at 30 frames a second"
std::string playerText(const PlayerVerdict& player, bool namesBodies);

}  // namespace obby::solve
