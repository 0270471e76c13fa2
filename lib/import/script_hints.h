// Guesses from the texts of scripts that did not run.
#pragma once

#include "import/observed/run.h"
#include "import/roles/role.h"

namespace obby::importer {

// Where no script ran, of all of them; else of those that failed. Names each script that did not
// run at all.
void hintsFromScripts(RoleContext& context, const ObservedPlace& place);

}  // namespace obby::importer
