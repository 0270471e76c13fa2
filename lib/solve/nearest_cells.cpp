#include "solve/nearest_cells.h"

#include <algorithm>

#include "solve/cell.h"

namespace obby::solve {

namespace {

// Studs: about as many blocks as a level has surfaces, with some dozens of cells each.
constexpr float kBlock = 12;

float square(float v) { return v * v; }

}  // namespace

void NearestCells::add(uint32_t layer, Vec3 position, uint32_t cell) {
  if (layer >= layers_.size()) layers_.resize(layer + 1);
  Layer& l = layers_[layer];
  const auto [slot, isNew] =
      l.blockOf.try_emplace(packedCell(position * (1 / kBlock)), uint32_t(l.bounds.size()));
  if (isNew) {
    l.bounds.push_back({position, position});
    l.entries.emplace_back();
  }
  Bounds& b = l.bounds[slot->second];
  b.low = min(b.low, position);
  b.high = max(b.high, position);
  l.entries[slot->second].push_back({position, cell});
}

// Never more than the distance of an entry: each operation is monotonic, rounding included.
float NearestCells::distance2(const Bounds& b, Vec3 to) {
  const float x = std::max({b.low.x - to.x, to.x - b.high.x, 0.0f});
  const float y = std::max({b.low.y - to.y, to.y - b.high.y, 0.0f});
  const float z = std::max({b.low.z - to.z, to.z - b.high.z, 0.0f});
  return square(x) + square(y) + square(z);
}

void NearestCells::search(const std::vector<Entry>& block, Vec3 to, Found& found) {
  for (const Entry& e : block) {
    const float d =
        square(e.position.x - to.x) + square(e.position.y - to.y) + square(e.position.z - to.z);
    if (d > found.distance2 || (d == found.distance2 && e.cell > found.cell)) continue;
    found = {d, e.cell};
  }
}

uint32_t NearestCells::nearest(uint32_t layer, Vec3 to) const {
  const Layer& l = layers_[layer];
  if (l.bounds.empty()) return level::kNone;
  size_t first = 0;
  float least = distance2(l.bounds[0], to);
  for (size_t i = 1; i < l.bounds.size() && least > 0; ++i) {
    const float d = distance2(l.bounds[i], to);
    if (d >= least) continue;
    least = d;
    first = i;
  }
  Found found{1e38f, level::kNone};
  search(l.entries[first], to, found);
  for (size_t i = 0; i < l.bounds.size(); ++i) {
    if (i == first || distance2(l.bounds[i], to) > found.distance2) continue;
    search(l.entries[i], to, found);
  }
  return found.cell;
}

}  // namespace obby::solve
