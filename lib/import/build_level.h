// Builds a level from a document, step by step.
#pragma once

#include <string>

#include "import/draft.h"
#include "import/observed/place.h"
#include "import/tree.h"

namespace obby::importer {

// Returns the level of a place. `tree` must be the tree of the place's document.
LevelDraft buildLevel(const Tree& tree, const ObservedPlace& place, const std::string& name);

}  // namespace obby::importer
