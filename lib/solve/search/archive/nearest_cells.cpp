#include "solve/search/archive/nearest_cells.h"

#include <algorithm>

#include "solve/search/archive/cell.h"

namespace obby::solve {

namespace {

// Studs. A level has about as many blocks as surfaces, with some dozens of cells each.
constexpr float kBlock = 8;

float square(float v) { return v * v; }

}  // namespace

void NearestCells::grow(Bounds& b, size_t block, Vec3 position) {
  const auto take = [&](std::vector<float>& low, std::vector<float>& high, float v) {
    if (block == low.size()) {
      low.push_back(v);
      high.push_back(v);
    }
    low[block] = std::min(low[block], v);
    high[block] = std::max(high[block], v);
  };
  take(b.lowX, b.highX, position.x);
  take(b.lowY, b.highY, position.y);
  take(b.lowZ, b.highZ, position.z);
}

void NearestCells::add(uint32_t layer, Vec3 position, uint32_t cell) {
  if (layer >= layers_.size()) layers_.resize(layer + 1);
  Layer& l = layers_[layer];
  const auto [slot, isNew] =
      l.blockOf.try_emplace(packedCell(position * (1 / kBlock)), uint32_t(l.entries.size()));
  if (isNew) l.entries.emplace_back();
  grow(l.bounds, slot->second, position);
  l.entries[slot->second].push_back({position, cell});
}

// Returns the squared distances to the blocks' bounds. None exceeds the squared distance to an
// entry of the block: each operation is monotonic, rounding included.
std::vector<float> NearestCells::distances2(const Bounds& b, Vec3 to) {
  std::vector<float> result(b.lowX.size());
  float* const out = result.data();
  for (size_t i = 0; i < result.size(); ++i) {
    const float x = maxf(maxf(b.lowX[i] - to.x, to.x - b.highX[i]), 0.0f);
    const float y = maxf(maxf(b.lowY[i] - to.y, to.y - b.highY[i]), 0.0f);
    const float z = maxf(maxf(b.lowZ[i] - to.z, to.z - b.highZ[i]), 0.0f);
    out[i] = square(x) + square(y) + square(z);
  }
  return result;
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
  if (l.entries.empty()) return level::kNone;
  const std::vector<float> bounds = distances2(l.bounds, to);
  const size_t first = size_t(std::min_element(bounds.begin(), bounds.end()) - bounds.begin());
  Found found{1e38f, level::kNone};
  search(l.entries[first], to, found);
  for (size_t i = 0; i < bounds.size(); ++i) {
    if (i != first && bounds[i] <= found.distance2) search(l.entries[i], to, found);
  }
  return found.cell;
}

}  // namespace obby::solve
