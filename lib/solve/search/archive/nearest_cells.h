// Finds the archive's cell nearest to a place, among cells of equal progress along a query. Host
// only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "math/vec.h"

namespace obby::solve {

class NearestCells {
 public:
  // `layer`: progress along the query. Each cell is added once, in ascending order. O(1).
  void add(uint32_t layer, Vec3 position, uint32_t cell);

  // Returns the cell of the layer whose position is nearest to `to`, the lowest of equally near
  // ones; kNone if the layer is empty. Thread-safe between changes.
  uint32_t nearest(uint32_t layer, Vec3 to) const;

  uint32_t layers() const { return uint32_t(layers_.size()); }  // up to the last with a cell
  bool empty(uint32_t layer) const { return layers_[layer].entries.empty(); }

 private:
  struct Entry {
    Vec3 position;
    uint32_t cell;
  };
  struct Bounds {  // bounds of the blocks' entries, an array for each coordinate, for SIMD
    std::vector<float> lowX, lowY, lowZ, highX, highY, highZ;
  };
  struct Found {
    float distance2;
    uint32_t cell;
  };
  struct Layer {
    Bounds bounds;                            // (blocks)
    std::vector<std::vector<Entry>> entries;  // (blocks)
    std::unordered_map<uint64_t, uint32_t> blockOf;
  };
  static void grow(Bounds& b, size_t block, Vec3 position);
  static std::vector<float> distances2(const Bounds& b, Vec3 to);
  static void search(const std::vector<Entry>& block, Vec3 to, Found& found);

  std::vector<Layer> layers_;
};

}  // namespace obby::solve
