// Builds the uniform grid of LevelView over the colliders' bounds.
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

// Reach of a player's rays and limbs around the feet, plus the distance that a tick may carry the
// player.
struct Reach {
  float side, down, up;  // studs
};

// Pads lists with `filler`, the index of a collider that nothing meets. Grows the cells until at
// most 2^21 of them cover the bounds.
GridTables buildGrid(std::span<const Bounds> bounds, uint32_t filler, const Reach& reach);

}  // namespace obby::level
