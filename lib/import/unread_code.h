// Code that is not read, or not to its end.
#pragma once

#include "import/roles/role.h"

namespace obby::importer {

// Names in level.unmodelled the modules that do something to parts: what is in them is not
// followed. The player's own modules are no part of a level.
void noteModules(RoleContext& context);

// Names in level.unmodelled what was left out of one script's text, or of what it sets.
void noteUnread(RoleContext& context, const ScriptReading& reading);

}  // namespace obby::importer
