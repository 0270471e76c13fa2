#include "solve/proof/crowding.h"

#include <algorithm>

#include "sim/candidates.h"
#include "solve/proof/boxes.h"

namespace obby::solve {

namespace {

constexpr float kRounding = 0.125f;  // studs
constexpr size_t kMostPlaces = 256;

// Does the list of a cell have more parts than a tick looks at? It names all that a player in the
// cell can be near, at any speed.
bool isCrowd(const level::LevelView& level, const uint32_t* list) {
  const auto moves = [&](uint32_t id) { return (level.bounds[id].flags & level::kMoving) != 0; };
  const int moving = int(std::count_if(list + 1, list + 1 + list[0], moves));
  return list[0] > uint32_t(sim::kMaxCandidates) || moving > sim::kMaxMovingCandidates;
}

}  // namespace

std::vector<Box> crowdedPlaces(const level::LevelView& level) {
  const level::Grid& g = level.grid;
  const Vec3 size{1 / g.inverseCell.x, 1 / g.inverseCell.y, 1 / g.inverseCell.z};
  std::vector<Box> places;
  std::vector<int8_t> known(g.listWords, -1);  // by where a list begins
  size_t cell = 0;
  for (int32_t z = 0; z < g.nz; ++z) {
    for (int32_t y = 0; y < g.ny; ++y) {
      for (int32_t x = 0; x < g.nx; ++x, ++cell) {
        const uint32_t at = g.cells[cell];
        if (known[at] < 0) known[at] = isCrowd(level, g.lists + at) ? 1 : 0;
        if (known[at] == 0) continue;
        const Vec3 lo = g.origin + mul(size, Vec3{float(x), float(y), float(z)});
        places.push_back(grow(Box{lo, lo + size}, {kRounding, kRounding, kRounding}));
      }
    }
  }
  return fewBoxes(std::move(places), kMostPlaces);
}

}  // namespace obby::solve
