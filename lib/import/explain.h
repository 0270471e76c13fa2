// A table for people: what the importer made of each part and why, what it guessed, what it left
// out.
#pragma once

#include <string>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Lines of at most 100 columns; parts with the same name, folder, role and reason share a line.
std::string explain(const LevelDraft& level, const Tree& tree);

}  // namespace obby::importer
