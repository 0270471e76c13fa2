// The geometry of one part instance: shape, pose, size, surface, switches. No roles.
#pragma once

#include "import/draft.h"
#include "import/hulls.h"
#include "import/tree.h"

namespace obby::importer {

// Notes a repaired reflection and a collision shape that had to be guessed in `level`; `hulls` are
// those of its parts so far. Nothing is returned for a part whose numbers are not finite (noted as
// well).
std::optional<PartDraft> partFrom(const Tree& tree, InstanceId id, LevelHulls& hulls,
                                  LevelDraft& level);

}  // namespace obby::importer
