// Terrain is not modelled.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Names it in the level, if the place has voxels that a player could stand on.
void noteTerrain(RoleContext& context);

}  // namespace obby::importer
