// What scripts change of parts by themselves and no role models.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Names in level.unmodelled what scripts do to parts after the start, under conditions or on a
// player's client alone, as far as the parts would differ from what the level has: CanCollide,
// CanTouch, Anchored, places, Destroy; sizes as well where they change by and by. What moves and
// what vanishes by the clock is modelled. Call it after findRoles and looseParts.
void noteScriptedChanges(RoleContext& context);

}  // namespace obby::importer
