// Writes terrain voxels as Studio saves them. A function returns each cell's content.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace obby::test {

struct Cell {
  uint8_t material = 0, occupancy = 0;  // 0: air
  bool operator==(const Cell&) const = default;
};

struct ChunkPlace {
  int x = 0, y = 0, z = 0;
};

using CellAt = std::function<Cell(int x, int y, int z)>;

class VoxelWriter {
 public:
  // Adds a chunk. Chunks may come in any order.
  VoxelWriter& chunk(ChunkPlace at, const CellAt& cellAt) {
    offset(at);
    for (int i = 0; i < 32 * 32 * 32;) {
      const auto cell = [&](int n) {
        return cellAt(at.x * 32 + n % 32, at.y * 32 + n / 1024, at.z * 32 + n / 32 % 32);
      };
      const Cell first = cell(i);
      int count = 1;
      while (count < 256 && i + count < 32 * 32 * 32 && cell(i + count) == first) ++count;
      run(first, count);
      i += count;
    }
    last_ = at;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void offset(ChunkPlace at) {
    const uint32_t axes[] = {uint32_t(at.x - last_.x), uint32_t(at.y - last_.y),
                             uint32_t(at.z - last_.z)};
    for (int byte = 3; byte >= 0; --byte)
      for (const uint32_t axis : axes) bytes_ += char(axis >> (8 * byte));
  }
  void run(Cell cell, int count) {
    const bool isPlain = cell.material == 0 || cell.occupancy == 255;
    bytes_ += char(cell.material | (isPlain ? 0 : 0x40) | (count > 1 ? 0x80 : 0));
    if (!isPlain) bytes_ += char(cell.occupancy);
    if (count > 1) bytes_ += char(count - 1);
  }

  std::string bytes_ = std::string("\1\5", 2);
  ChunkPlace last_;
};

}  // namespace obby::test
