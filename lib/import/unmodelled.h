// Names what the importer saw and the simulator does not do.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Terrain, seats, tools, collision groups, teleporters, buttons, scripts that were not understood.
// Call it after findRoles.
void noteUnmodelled(RoleContext& context);

// What scripts do to the world's constants as play starts: gravity, and the speed, jump and health
// that they give to each new character. Call it before findRoles.
void applyScriptedWorld(RoleContext& context);

}  // namespace obby::importer
