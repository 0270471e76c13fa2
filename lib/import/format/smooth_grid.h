// Reads the voxels of smooth terrain: the blob SmoothGrid of a Terrain.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace obby::importer {

constexpr int kChunkSide = 32;        // cells
constexpr float kCellSide = 4;        // studs
constexpr int kFarthestCell = 32000;  // cells from the origin, on each axis

// Materials that are not solid; all others are.
constexpr uint8_t kTerrainAir = 0, kTerrainWater = 1;

// One cube of cells. `x`, `y`, `z` count chunks from the origin.
struct VoxelChunk {
  int x = 0, y = 0, z = 0;
  std::string_view runs;  // run-length code as stored
};

// Cells by index y * 1024 + z * 32 + x.
struct Voxels {
  std::array<uint8_t, size_t(kChunkSide) * kChunkSide * kChunkSide> material, occupancy;
  size_t water = 0;  // number of cells that hold some
};

// Returns the chunks in file order, with their runs checked. They refer to `blob`. Fails if the
// blob is damaged.
Result<std::vector<VoxelChunk>> voxelChunks(std::string_view blob);

// Reads one of the chunks of voxelChunks().
void readVoxels(const VoxelChunk& chunk, Voxels& out);

}  // namespace obby::importer
