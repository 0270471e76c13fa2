// Reads the geometry of one part instance: shape, pose, size, surface, switches. It decides no
// roles.
#pragma once

#include "import/document/tree.h"
#include "import/draft/draft.h"
#include "import/parts/hulls.h"

namespace obby::importer {

// Returns the part, or nullopt if its numbers are not finite. Notes in `level` non-finite numbers,
// a repaired reflection and a guessed collision shape. `hulls` holds the hulls of the level's parts
// so far.
std::optional<PartDraft> partFrom(const Tree& tree, InstanceId id, LevelHulls& hulls,
                                  LevelDraft& level);

}  // namespace obby::importer
