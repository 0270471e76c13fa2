// The constants of the world and its player: gravity, speeds, health, the fall height.
#pragma once

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// Fills level.world from Workspace, StarterPlayer and a StarterHumanoid; a model file keeps the
// defaults. What would make the player another one (a custom character, the Character Controller
// Library) is noted in level.unmodelled.
void readWorld(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
