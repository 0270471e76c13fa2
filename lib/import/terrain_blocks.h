// Voxels to blocks. The engine's surface runs where the terrain fills half of the space; on level
// ground the occupancy of the top cell gives its height. So a column of cells stands from the
// bottom of its lowest cell to that height, and equal columns side by side make one block.
#pragma once

#include <cstdint>
#include <vector>

#include "import/format/smooth_grid.h"

namespace obby::importer {

constexpr int kStepsPerCell = 16;  // heights are multiples of a quarter of a stud

// From `lo` to `hi`: cells in x and z, steps of height in y.
struct TerrainBlock {
  int x0 = 0, x1 = 0, z0 = 0, z1 = 0;
  int bottom = 0, top = 0;
  uint8_t material = 0;
};

struct TerrainShape {
  std::vector<TerrainBlock> blocks;
  size_t water = 0;    // cells
  size_t slopes = 0;   // pairs of neighbouring columns whose tops differ by less than two cells
  bool isCut = false;  // more blocks than asked for
};

// Adds the blocks of chunks one above the other: of one x and z, ascending by y. Stops behind the
// chunk that makes them more than `most`; returns how many chunks that were.
size_t addColumns(const std::vector<VoxelChunk>& stack, size_t most, TerrainShape& shape);

// Joins blocks of equal height and material that meet, also over the borders of chunks. None gets
// longer than a part may be.
void joinBlocks(std::vector<TerrainBlock>& blocks);

}  // namespace obby::importer
