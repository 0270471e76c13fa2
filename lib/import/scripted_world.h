// What scripts make of the world's constants.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Gravity that a script sets as play starts, and the speed and jump that scripts give to each new
// character. What a script does only under some condition, or computes, is noted in
// level.unmodelled. Call it after readWorld and before findRoles.
void applyScriptedWorld(RoleContext& context);

}  // namespace obby::importer
