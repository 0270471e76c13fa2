// Removes stray parts. No player can meet them, and they would only make the search space huge.
#pragma once

#include "import/draft/draft.h"

namespace obby::importer {

class Tree;

// Removes parts wholly below the fall height, and parts farther from the rest than ten times its
// extent. Counts them in level.partsCulled and level.ignored.
void cullStrays(LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
