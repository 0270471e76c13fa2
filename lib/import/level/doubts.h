// Decides which parts each loss of the import concerns.
#pragma once

#include "import/draft/role_context.h"

namespace obby::importer {

// The direction in which the game can differ from the level because of a loss.
enum class Bearing : uint8_t {
  either,  // easier or harder for the player
  easier,  // easier only: a solution still holds
  harder,  // harder only: an unreachable goal stays unreachable
};
Bearing bearingOf(const std::string& kind);

// Marks the parts that each of level.losses concerns: the part where it was found, the parts that a
// joint connects, or all parts of the model or folder around a script. A loss at a service, or in a
// folder of more than half of the level, concerns no single part and sets `anywhere`.
void markDoubts(RoleContext& context);

}  // namespace obby::importer
