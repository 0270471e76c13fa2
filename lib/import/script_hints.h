// Guesses from the texts of scripts that did not run.
#pragma once

#include "import/observed/place.h"
#include "import/roles/role.h"

namespace obby::importer {

// Where no script ran, of all of them; else of those that failed after they had used what the twin
// does not do: other errors end a script in the game, too. Names each script that did not run at
// all.
void hintsFromScripts(RoleContext& context, const ObservedPlace& place);

}  // namespace obby::importer
