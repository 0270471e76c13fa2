// Turns the voxels of terrain into solid blocks.
#pragma once

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Max blocks of terrain in a level. Those farthest from its parts are left out.
constexpr size_t kMaxTerrainBlocks = 20000;

// Adds the blocks to the parts of the level. Notes omissions: water, the surface of slopes, damaged
// voxels, terrain too far away or beyond the limit.
void addTerrain(const Tree& tree, LevelDraft& level);

}  // namespace obby::importer
