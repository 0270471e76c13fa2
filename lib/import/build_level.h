// The steps from a document to a level, in order.
#pragma once

#include <string>

#include "import/draft.h"
#include "import/observed/place.h"
#include "import/tree.h"

namespace obby::importer {

// `tree` is that of the place's document.
LevelDraft buildLevel(const Tree& tree, const ObservedPlace& place, const std::string& name);

}  // namespace obby::importer
