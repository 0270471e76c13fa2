// Decides which parts the player can push: pushboxes of tower kits, and unanchored parts within the
// simulator's capacity.
#pragma once

#include "import/document/assemblies.h"
#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Unanchors pushboxes, which kits save anchored. Anchors unanchored parts that joints hold
// together: a simulated body has one part only. Anchors parts that vanish, since bodies cannot. If
// more parts are unanchored than a level may have, only pushboxes stay unanchored: the rest is
// usually scenery. The level notes each change.
void dynamicParts(const Tree& tree, const Assemblies& assemblies, LevelDraft& level);

}  // namespace obby::importer
