// Names what the importer saw and the simulator does not do.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Terrain, seats, tools, teleporters, buttons, parts that scripts change in play,
// scripts that were not understood. Call it after findRoles and looseParts.
void noteUnmodelled(RoleContext& context);

}  // namespace obby::importer
