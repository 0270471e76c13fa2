// Finds parts that depend on random numbers drawn by scripts.
#pragma once

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Notes each part of `level` that differs in `other`, the level of the same place under other
// random numbers. Instances below `fromFile` are those of the file. Parts that scripts made are
// compared by their content.
void noteChance(LevelDraft& level, const Tree& tree, size_t fromFile, const LevelDraft& other);

}  // namespace obby::importer
