// Doubts: which parts each loss of the import concerns.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// How the game can differ from the level because of a loss.
enum class Bearing : uint8_t {
  either,  // easier or harder for the player
  easier,  // easier only: a solution holds all the same
  harder,  // harder only: what is unreachable stays unreachable
};
Bearing bearingOf(const std::string& kind);

// Marks the parts that each of level.losses concerns: the part at which it was found, the parts
// that a joint connects, or all parts of the model or folder around a script. A loss at a service,
// or in a folder of more than half of the level, concerns no single part: `anywhere` is set.
void markDoubts(RoleContext& context);

}  // namespace obby::importer
