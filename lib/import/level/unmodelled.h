// Notes what the importer saw and the simulator does not model.
#pragma once

#include "import/draft/role_context.h"

namespace obby::importer {

// Notes terrain, seats, tools, teleporters, buttons, parts that scripts change in play, and scripts
// that were not understood. Call it after findRoles and looseParts.
void noteUnmodelled(RoleContext& context);

}  // namespace obby::importer
