#include "solve/search/archive/heat_map.h"

#include <utility>

#include "level/record_values.h"
#include "solve/search/archive/cell.h"

namespace obby::solve {

namespace {

constexpr size_t kMaxCubes = 4096;  // about 200 kB of JSON

}  // namespace

void HeatMap::note(const std::vector<Vec3>& places) {
  for (const Vec3 feet : places) {
    add(feet, 1);
    while (cubes_.size() > kMaxCubes) coarsen();
  }
}

void HeatMap::add(Vec3 feet, uint32_t cells) {
  const Key key{floorToInt(feet.x / size_), floorToInt(feet.y / size_), floorToInt(feet.z / size_)};
  const auto [at, isNew] = cubes_.try_emplace(key, Cube{feet, 0});
  Cube& cube = at->second;
  if (!isNew && feet.y < cube.feet.y) cube.feet = feet;
  cube.cells += cells;
}

// Merges eight cubes into one, which keeps the lowest feet.
void HeatMap::coarsen() {
  size_ *= 2;
  for (const auto& [key, cube] : std::exchange(cubes_, {})) add(cube.feet, cube.cells);
}

void HeatMap::fill(schema::HeatMap::Builder record) const {
  record.setSize(size_);
  auto cubes = record.initCubes(uint32_t(cubes_.size()));
  uint32_t i = 0;
  for (const auto& [key, cube] : cubes_) {
    level::set(cubes[i].initFeet(), cube.feet);
    cubes[i++].setCells(cube.cells);
  }
}

}  // namespace obby::solve
