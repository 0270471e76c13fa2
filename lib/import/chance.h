// What depends on random numbers that scripts draw.
#pragma once

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Names each part of `level` that is another one in `other`: the level of the same place when its
// scripts drew other random numbers. Instances below `fromFile` are those of the file; parts that
// scripts made are compared by what they are.
void noteChance(LevelDraft& level, const Tree& tree, size_t fromFile, const LevelDraft& other);

}  // namespace obby::importer
