// Decides which instances belong to the level: those that a player meets when play starts.
#pragma once

#include <vector>

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Returns the parts of the level in file order. Omitted ones (storage, rigs, gear, negations) are
// counted in `level`, by kind.
std::vector<InstanceId> sceneParts(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
