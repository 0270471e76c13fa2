// Handlers of touches and frames that scripts disconnect, that a flag keeps from a second time or
// from the first ones, or that may not be connected at all.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Names in level.unmodelled what the level does again and again although the script disconnects the
// handler that does it, or sets a flag that nothing sets back, as of a door that opens at the first
// touch only; and what it does although the text does not tell whether the handler is connected,
// whether it harms by then, or whether another script has enabled its script.
// What is gone for good, or is a checkpoint, may come but once. Call it after findRoles.
void noteEndedHandlers(RoleContext& context);

}  // namespace obby::importer
