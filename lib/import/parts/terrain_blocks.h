// Joins voxels into blocks. The engine's surface lies where the terrain fills half of the space. On
// level ground the occupancy of the top cell gives its height. So a column stands from the bottom
// of its lowest cell to that height. Adjacent columns of equal height make one block.
#pragma once

#include <cstdint>
#include <vector>

#include "import/format/smooth_grid.h"

namespace obby::importer {

constexpr int kStepsPerCell = 16;  // steps of a quarter of a stud

// The box from `lo` to `hi`: cells in x and z, steps of height in y.
struct TerrainBlock {
  int x0 = 0, x1 = 0, z0 = 0, z1 = 0;
  int bottom = 0, top = 0;
  uint8_t material = 0;
};

struct TerrainShape {
  std::vector<TerrainBlock> blocks;
  size_t water = 0;    // number of cells
  size_t slopes = 0;   // pairs of neighbouring columns whose tops differ by less than two cells
  bool isCut = false;  // there were more blocks than the limit
};

// Adds the blocks of a stack of chunks with one x and z, ascending by y. Stops after the chunk that
// makes them exceed `most`. Returns how many chunks it read.
size_t addColumns(const std::vector<VoxelChunk>& stack, size_t most, TerrainShape& shape);

// Joins adjacent blocks of equal height and material, also across chunk borders. No block gets
// longer than a part may be.
void joinBlocks(std::vector<TerrainBlock>& blocks);

}  // namespace obby::importer
