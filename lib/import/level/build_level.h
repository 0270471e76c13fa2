// Builds a level from a document, step by step.
#pragma once

#include <string>

#include "import/document/observed_place.h"
#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Returns the level of a place. `tree` must be the tree of the place's document.
LevelDraft buildLevel(const Tree& tree, const ObservedPlace& place, const std::string& name);

}  // namespace obby::importer
