// Builds columns of solid cells, then rectangles of equal columns, then longer rectangles.
#include "import/parts/terrain_blocks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <memory>
#include <tuple>

namespace obby::importer {
namespace {

constexpr int kHalfFull = kStepsPerCell / 2;  // an emptier cell has no surface of its own
constexpr int kLongestBlock = 512;            // cells: 2048 studs
constexpr size_t kColumns = size_t(kChunkSide) * kChunkSide;

// A piece of a column, in steps of height.
struct Piece {
  int bottom = 0, top = 0;
  uint8_t material = 0;
  uint16_t column = 0;  // z * 32 + x
};

auto keyOf(const Piece& p) { return std::make_tuple(p.bottom, p.top, p.material, p.column); }

// Returns the height of solid matter, in steps.
int fillOf(uint8_t material, uint8_t occupancy) {
  if (material == kTerrainAir || material == kTerrainWater) return 0;
  return (int(occupancy) * kStepsPerCell + 127) / 255;
}

// Follows one column upwards, cell by cell.
class GroundColumn {
 public:
  // Adds a cell; `floor` is the cell's bottom.
  void cell(int floor, int fill, uint8_t material, uint16_t column, std::vector<Piece>& out) {
    const bool hasSurface = fill >= kHalfFull;
    if (hasSurface && !open_)
      begin(floor, fill);
    else if (open_ && fill > 0)
      floor_ = bottom_;  // the column has several cells
    if (open_ && fill > 0) {
      top_ = floor + fill;
      material_ = material;
    }
    if (!hasSurface) end(column, out);
    below_ = hasSurface ? 0 : fill;
  }
  void end(uint16_t column, std::vector<Piece>& out) {
    if (open_) out.push_back({floor_, top_, material_, column});
    open_ = false;
    below_ = 0;
  }

 private:
  void begin(int floor, int fill) {
    open_ = true;
    bottom_ = below_ > 0 ? floor - below_ : floor + kStepsPerCell - fill;
    // A single cell stands on its floor, so the empty part is at the top.
    floor_ = below_ > 0 ? bottom_ : floor;
  }

  bool open_ = false;
  int bottom_ = 0, floor_ = 0, top_ = 0;
  int below_ = 0;  // fill of the cell below, if it has no surface of its own
  uint8_t material_ = 0;
};

// The columns that have the same piece: a row of bits for each z.
using Rows = std::array<uint32_t, kChunkSide>;

constexpr uint32_t bitsFrom(int first, int count) {
  return (count == 32 ? ~0u : (1u << count) - 1) << first;
}

// Cuts rectangles from the rows until nothing is left.
void takeRectangles(Rows& rows, TerrainBlock like, int x, int z, std::vector<TerrainBlock>& out) {
  for (int row = 0; row < kChunkSide; ++row) {
    while (rows[size_t(row)] != 0) {
      const int first = std::countr_zero(rows[size_t(row)]);
      const int count = std::countr_one(rows[size_t(row)] >> first);
      const uint32_t mask = bitsFrom(first, count);
      int end = row;
      while (end < kChunkSide && (rows[size_t(end)] & mask) == mask) rows[size_t(end++)] &= ~mask;
      like.x0 = x + first;
      like.x1 = x + first + count;
      like.z0 = z + row;
      like.z1 = z + end;
      out.push_back(like);
    }
  }
}

void addPieces(std::vector<Piece>& pieces, int x, int z, std::vector<TerrainBlock>& out) {
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return keyOf(a) < keyOf(b); });
  for (size_t at = 0; at < pieces.size();) {
    const Piece& first = pieces[at];
    Rows rows{};
    for (; at < pieces.size() && pieces[at].bottom == first.bottom && pieces[at].top == first.top &&
           pieces[at].material == first.material;
         ++at)
      rows[pieces[at].column / kChunkSide] |= 1u << pieces[at].column % kChunkSide;
    takeRectangles(rows, {0, 0, 0, 0, first.bottom, first.top, first.material}, x, z, out);
  }
}

// Counts slopes among the highest pieces of adjacent columns.
size_t slopesOf(const std::vector<Piece>& pieces) {
  constexpr int kNone = -(1 << 30), kSteep = 2 * kStepsPerCell;
  std::array<int, kColumns> tops;
  tops.fill(kNone);
  for (const Piece& piece : pieces) tops[piece.column] = std::max(tops[piece.column], piece.top);
  const auto isSlope = [&](size_t a, size_t b) {
    return tops[a] != kNone && tops[b] != kNone && tops[a] != tops[b] &&
           std::abs(tops[a] - tops[b]) < kSteep;
  };
  size_t count = 0;
  for (size_t i = 0; i < kColumns; ++i) {
    if (i % kChunkSide != 0 && isSlope(i, i - 1)) ++count;
    if (i >= kChunkSide && isSlope(i, i - kChunkSide)) ++count;
  }
  return count;
}

// Joins blocks that follow one another along an axis and are equal otherwise.
void joinAlong(std::vector<TerrainBlock>& blocks, int TerrainBlock::*lo, int TerrainBlock::*hi,
               int TerrainBlock::*side0, int TerrainBlock::*side1) {
  const auto alike = [&](const TerrainBlock& b) {
    return std::make_tuple(b.bottom, b.top, b.material, b.*side0, b.*side1);
  };
  std::sort(blocks.begin(), blocks.end(), [&](const TerrainBlock& a, const TerrainBlock& b) {
    return std::make_pair(alike(a), a.*lo) < std::make_pair(alike(b), b.*lo);
  });
  size_t kept = 0;
  for (size_t i = 1; i < blocks.size(); ++i) {
    TerrainBlock& last = blocks[kept];
    const TerrainBlock& next = blocks[i];
    if (alike(last) == alike(next) && last.*hi == next.*lo && next.*hi - last.*lo <= kLongestBlock)
      last.*hi = next.*hi;
    else
      blocks[++kept] = next;
  }
  if (!blocks.empty()) blocks.resize(kept + 1);
}

}  // namespace

size_t addColumns(const std::vector<VoxelChunk>& stack, size_t max, TerrainShape& shape) {
  if (stack.empty()) return 0;
  std::vector<Piece> pieces;
  std::vector<GroundColumn> columns(kColumns);
  const auto voxels = std::make_unique<Voxels>();
  const auto endAll = [&] {
    for (size_t c = 0; c < kColumns; ++c) columns[c].end(uint16_t(c), pieces);
  };
  size_t i = 0;
  for (; i < stack.size() && !shape.isCut; ++i) {
    if (i > 0 && stack[i].y != stack[i - 1].y + 1) endAll();
    readVoxels(stack[i], *voxels);
    shape.water += voxels->water;
    for (size_t cell = 0; cell < voxels->material.size(); ++cell) {
      const size_t column = cell % kColumns;
      const int y = stack[i].y * kChunkSide + int(cell / kColumns);
      columns[column].cell(y * kStepsPerCell,
                           fillOf(voxels->material[cell], voxels->occupancy[cell]),
                           voxels->material[cell], uint16_t(column), pieces);
    }
    shape.isCut = shape.blocks.size() + pieces.size() > max;
  }
  endAll();
  shape.slopes += slopesOf(pieces);
  addPieces(pieces, stack[0].x * kChunkSide, stack[0].z * kChunkSide, shape.blocks);
  return i;
}

void joinBlocks(std::vector<TerrainBlock>& blocks) {
  using B = TerrainBlock;
  joinAlong(blocks, &B::x0, &B::x1, &B::z0, &B::z1);
  joinAlong(blocks, &B::z0, &B::z1, &B::x0, &B::x1);
  joinAlong(blocks, &B::x0, &B::x1, &B::z0, &B::z1);
}

}  // namespace obby::importer
