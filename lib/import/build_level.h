// The steps from a document to a level, in order.
#pragma once

#include <string>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

LevelDraft buildLevel(const Tree& tree, const std::string& name);

}  // namespace obby::importer
