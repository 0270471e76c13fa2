// Reads the bodies that a place gives to its players, and their sizes.
#pragma once

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Fills level.avatar from StarterPlayer. Settings that the simulator handles differently are noted
// in level.ignored.
void readAvatar(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
