// Handlers of touches and frames that scripts disconnect, or that a flag keeps from a second time.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Names in level.unmodelled what the level does again and again although the script disconnects the
// handler that does it, or sets a flag that nothing sets back, as of a door that opens at the first
// touch only. What is gone for good, or is a checkpoint, may come but once. Call it after
// findRoles.
void noteEndedHandlers(RoleContext& context);

}  // namespace obby::importer
