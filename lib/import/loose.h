// Which parts the player can push: pushboxes of tower kits, and unanchored parts as far as the
// simulator has room for them.
#pragma once

#include "import/assemblies.h"
#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Loosens pushboxes, which kits save anchored. Parts that joints hold together with other loose
// ones are anchored: the simulator has no bodies of several parts. So are those that vanish, which
// bodies cannot. Where more are loose than a level may have, only pushboxes stay so; the rest is
// scenery in most places. The level says what was done.
void looseParts(const Tree& tree, const Assemblies& assemblies, LevelDraft& level);

}  // namespace obby::importer
