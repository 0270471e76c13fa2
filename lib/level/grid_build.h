// Lays the uniform grid of LevelView over the colliders' bounds.
#pragma once

#include <span>
#include <vector>

#include "level/level_view.h"

namespace obby::level {

struct GridTables {
  Vec3 origin, cell;
  int32_t nx = 0, ny = 0, nz = 0;
  std::vector<uint32_t> cells;
  std::vector<uint32_t> lists;
};

// How far beyond the feet a player's rays and limbs reach, and how far a tick may carry the player.
struct Reach {
  float side, down, up;  // studs
};

// Lists are filled up with `filler`, the index of a collider that nothing meets. Cells grow until
// at most 2^21 of them cover the bounds.
GridTables buildGrid(std::span<const Bounds> bounds, uint32_t filler, const Reach& reach);

}  // namespace obby::level
