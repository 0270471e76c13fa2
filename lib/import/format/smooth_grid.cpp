// Decodes smooth terrain: a byte 1, log2 of a chunk's side, and chunks to the end.
//
// A chunk begins with three i32, its offset from the previous chunk in chunks. They are big-endian
// with interleaved bytes. Runs of equal cells follow.
//
// A run begins with a byte: the material (6 bits), a flag for an occupancy, and a flag for a
// length. Those bytes follow. If the length is 0, the water occupancy of the single cell follows.
#include "import/format/smooth_grid.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include "import/format/byte_reader.h"

namespace obby::importer {
namespace {

constexpr uint8_t kGridVersion = 1, kLogChunkSide = 5;
constexpr uint8_t kMaterialBits = 0x3f, kHasOccupancy = 0x40, kHasLength = 0x80;
constexpr uint8_t kFullCell = 255;
constexpr size_t kChunkCells = size_t(kChunkSide) * kChunkSide * kChunkSide;
constexpr int kFarthestChunk = kFarthestCell / kChunkSide;

struct VoxelRun {
  uint8_t material = kTerrainAir, occupancy = 0;
  size_t cells = 1;
  bool water = false;
};

VoxelRun readRun(ByteReader& reader) {
  VoxelRun run;
  const uint8_t flags = reader.u8();
  run.material = flags & kMaterialBits;
  run.occupancy = run.material == kTerrainAir ? 0 : kFullCell;
  if ((flags & kHasOccupancy) != 0) run.occupancy = reader.u8();
  const uint8_t length = (flags & kHasLength) != 0 ? reader.u8() : 0;
  const bool isShore = (flags & kHasLength) != 0 && length == 0;
  run.water = (isShore && reader.u8() > 0) || (run.material == kTerrainWater && run.occupancy > 0);
  run.cells = size_t(length) + 1;
  return run;
}

std::array<int32_t, 3> readOffset(ByteReader& reader) {
  std::array<uint32_t, 3> offset{};
  for (int byte = 0; byte < 4; ++byte)
    for (uint32_t& axis : offset) axis = axis << 8 | reader.u8();
  return {int32_t(offset[0]), int32_t(offset[1]), int32_t(offset[2])};
}

bool advance(int& axis, int32_t by) {
  const int64_t to = int64_t(axis) + by;
  if (std::llabs(to) > kFarthestChunk) return false;
  axis = int(to);
  return true;
}

Error brokenGrid(const ByteReader& reader, std::string message) {
  return Error{
      {}, "byte " + std::to_string(reader.position()), "SmoothGrid", std::move(message), {}};
}

}  // namespace

Result<std::vector<VoxelChunk>> voxelChunks(std::string_view blob) {
  ByteReader reader(blob);
  const uint8_t version = reader.u8(), side = reader.u8();
  if (!reader.ok() || version != kGridVersion || side != kLogChunkSide)
    return brokenGrid(reader, "expected version 1 and chunks of 32 cells");
  std::vector<VoxelChunk> chunks;
  VoxelChunk chunk;
  while (reader.remaining() > 0) {
    const auto offset = readOffset(reader);
    if (!advance(chunk.x, offset[0]) || !advance(chunk.y, offset[1]) ||
        !advance(chunk.z, offset[2]))
      return brokenGrid(reader, "a chunk lies outside the limits of terrain");
    const size_t begin = reader.position();
    size_t cells = 0;
    while (cells < kChunkCells && reader.ok()) cells += readRun(reader).cells;
    if (!reader.ok()) return brokenGrid(reader, "the data ends within a chunk");
    if (cells != kChunkCells) return brokenGrid(reader, "a run of cells exceeds its chunk");
    chunk.runs = blob.substr(begin, reader.position() - begin);
    chunks.push_back(chunk);
  }
  return chunks;
}

void readVoxels(const VoxelChunk& chunk, Voxels& out) {
  ByteReader reader(chunk.runs);
  out.water = 0;
  for (size_t at = 0; at < kChunkCells && reader.ok();) {
    const VoxelRun run = readRun(reader);
    const size_t count = std::min(run.cells, kChunkCells - at);
    std::fill_n(out.material.begin() + std::ptrdiff_t(at), count, run.material);
    std::fill_n(out.occupancy.begin() + std::ptrdiff_t(at), count, run.occupancy);
    if (run.water) out.water += count;
    at += count;
  }
}

}  // namespace obby::importer
