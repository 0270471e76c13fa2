// Terrain: its voxels become solid blocks.
#pragma once

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// The most blocks of terrain that a level has. Those farthest from its parts are left out.
constexpr size_t kMaxTerrainBlocks = 20000;

// Adds the blocks to the parts of the level. Notes what they lack: water, the surface of slopes,
// what is damaged, what is too far away or too much.
void addTerrain(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
