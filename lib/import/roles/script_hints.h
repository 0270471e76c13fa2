// Guesses roles from the texts of scripts that did not run.
#pragma once

#include "import/document/observed_place.h"
#include "import/draft/role_context.h"

namespace obby::importer {

// Reads the texts of all scripts if none ran. Else reads those that failed after using a feature
// that the twin lacks: other errors end a script in the game, too. Notes each script that did not
// run at all.
void hintsFromScripts(RoleContext& context, const ObservedPlace& place);

}  // namespace obby::importer
