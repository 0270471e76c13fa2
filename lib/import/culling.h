// Removes stray parts. No player can meet them, and they would only make the search space huge.
#pragma once

#include "import/draft.h"

namespace obby::importer {

class Tree;

// Removes parts that are wholly below the fall height. Removes parts that are farther from the rest
// than the rest is wide, by a wide margin. Counts both in level.partsCulled and level.ignored.
void cullStrays(LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
