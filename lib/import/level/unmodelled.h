// Notes what the importer saw and the simulator does not model.
#pragma once

#include "import/draft/role_context.h"

namespace obby::importer {

// Notes vehicle seats, tools, parts that players drag, names that suggest a role without giving it,
// and unsupported kit tags. Call it after findRoles and dynamicParts.
void noteUnmodelled(RoleContext& context);

}  // namespace obby::importer
