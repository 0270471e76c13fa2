// Formats a table for designers: each part's roles with their reasons, guesses and omissions.
#pragma once

#include <string>

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Returns lines of at most 100 columns. Parts with the same name, folder, role and reason share a
// line.
std::string explain(const LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
