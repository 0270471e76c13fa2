// Which instances belong to the level: what a player meets in the world when play starts.
#pragma once

#include <vector>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Parts of the level in file order. What is left out (storage, rigs, gear, negations) is counted in
// `level`, by kind.
std::vector<InstanceId> sceneParts(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
