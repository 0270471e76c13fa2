// Strays: parts that no player can meet, which would only make the search space huge.
#pragma once

#include "import/draft.h"

namespace obby::importer {

class Tree;

// Removes parts wholly below the fall height and parts much farther from the rest than the rest is
// wide; counts them in level.partsCulled and level.ignored.
void cullStrays(LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
