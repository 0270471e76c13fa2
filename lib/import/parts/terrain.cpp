// Adds terrain chunk by chunk, nearest to the parts first, up to a limit of chunks or blocks.
#include "import/parts/terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

#include "engine/classes/class_defaults.h"
#include "engine/values/materials.h"
#include "import/parts/part_distance.h"
#include "import/parts/terrain_blocks.h"
#include "io/text.h"

namespace obby::importer {
namespace {

constexpr size_t kEmptyTerrain = 64;   // bytes; voxels up to this size hold nothing to stand on
constexpr size_t kMaxChunks = 4096;    // 8192 studs square
constexpr size_t kMaxLooked = 200000;  // max blocks before equal ones are joined
constexpr const char* kTerrainKind = "terrain";  // kind in the level's list of losses

struct TerrainMaterial {
  uint32_t material;  // material of a part
  ColorRgb color;
};
// Part materials and colours by terrain material. The first row is terrain material 2.
constexpr TerrainMaterial kTerrainMaterials[] = {
    {1280, {106, 127, 63}},  {800, {63, 127, 107}},   {816, {127, 102, 63}},
    {848, {138, 86, 62}},    {1296, {143, 126, 95}},  {528, {139, 109, 79}},
    {896, {102, 108, 111}},  {1552, {101, 176, 234}}, {1328, {195, 199, 218}},
    {912, {137, 90, 71}},    {1344, {58, 46, 36}},    {788, {30, 30, 37}},
    {1360, {102, 92, 59}},   {804, {232, 156, 74}},   {1376, {115, 123, 107}},
    {880, {132, 123, 90}},   {1536, {129, 194, 224}}, {1284, {115, 132, 74}},
    {1392, {198, 189, 181}}, {820, {206, 173, 148}},  {836, {148, 148, 140}}};
constexpr uint8_t kFirstSolid = 2;

// Returns the voxels, which files store as a string of their own or a shared one.
std::string_view voxelBytes(const Instance& terrain, const char* name) {
  const auto* own = property<std::string>(terrain, name);
  const auto* shared = property<SharedBlob>(terrain, name);
  return own ? std::string_view(*own) : shared ? std::string_view(*shared->bytes) : "";
}

struct Stack {
  std::vector<VoxelChunk> chunks;  // chunks of one x and z, ascending by y
  float distance = 0;
};

GroundArea areaOf(int x0, int x1, int z0, int z1) {
  return {float(x0) * kCellSide, float(x1) * kCellSide, float(z0) * kCellSide,
          float(z1) * kCellSide};
}

GroundArea areaOf(const std::vector<VoxelChunk>& chunks) {
  const auto [x0, x1] = std::minmax_element(chunks.begin(), chunks.end(),
                                            [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [z0, z1] = std::minmax_element(chunks.begin(), chunks.end(),
                                            [](const auto& a, const auto& b) { return a.z < b.z; });
  return areaOf(x0->x * kChunkSide, (x1->x + 1) * kChunkSide, z0->z * kChunkSide,
                (z1->z + 1) * kChunkSide);
}

// Returns the stacks, nearest first.
std::vector<Stack> stacksOf(std::vector<VoxelChunk> chunks, const PartDistance& distance) {
  const auto place = [](const VoxelChunk& c) { return std::make_tuple(c.x, c.z, c.y); };
  std::stable_sort(chunks.begin(), chunks.end(),
                   [&](const VoxelChunk& a, const VoxelChunk& b) { return place(a) < place(b); });
  std::vector<Stack> stacks;
  for (const VoxelChunk& chunk : chunks) {
    const VoxelChunk* last = stacks.empty() ? nullptr : &stacks.back().chunks.back();
    if (last == nullptr || last->x != chunk.x || last->z != chunk.z) {
      const int x = chunk.x * kChunkSide, z = chunk.z * kChunkSide;
      stacks.push_back({{chunk}, distance.of(areaOf(x, x + kChunkSide, z, z + kChunkSide))});
    } else if (last->y != chunk.y) {
      stacks.back().chunks.push_back(chunk);
    }
  }
  std::stable_sort(stacks.begin(), stacks.end(),
                   [](const Stack& a, const Stack& b) { return a.distance < b.distance; });
  return stacks;
}

struct Terrain {
  TerrainShape shape;
  size_t chunksLeft = 0, blocksLeft = 0;
  float leftFrom = 0;  // studs from the parts; terrain nearer than this is complete
};

void leaveOut(Terrain& terrain, size_t& count, size_t more, float from) {
  terrain.leftFrom =
      terrain.chunksLeft + terrain.blocksLeft == 0 ? from : std::min(terrain.leftFrom, from);
  count += more;
}

// Keeps the nearest kMaxTerrainBlocks, in the order of their positions.
void keepNearest(Terrain& terrain, const PartDistance& distance) {
  auto& blocks = terrain.shape.blocks;
  if (blocks.size() > kMaxTerrainBlocks) {
    std::vector<std::pair<float, size_t>> order;
    for (size_t i = 0; i < blocks.size(); ++i) {
      const TerrainBlock& b = blocks[i];
      order.emplace_back(distance.of(areaOf(b.x0, b.x1, b.z0, b.z1)), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<TerrainBlock> kept;
    for (size_t i = 0; i < kMaxTerrainBlocks; ++i) kept.push_back(blocks[order[i].second]);
    leaveOut(terrain, terrain.blocksLeft, blocks.size() - kMaxTerrainBlocks,
             order[kMaxTerrainBlocks].first);
    blocks = std::move(kept);
  }
  const auto place = [](const TerrainBlock& b) { return std::make_tuple(b.x0, b.z0, b.bottom); };
  std::sort(blocks.begin(), blocks.end(),
            [&](const TerrainBlock& a, const TerrainBlock& b) { return place(a) < place(b); });
}

Terrain shapeOf(std::vector<VoxelChunk> chunks, const std::vector<PartDraft>& parts) {
  Terrain terrain;
  if (chunks.empty()) return terrain;
  const PartDistance distance(parts, areaOf(chunks));
  size_t looked = 0;
  for (const Stack& stack : stacksOf(std::move(chunks), distance)) {
    const size_t count = stack.chunks.size();
    const bool isFull = terrain.shape.isCut || looked + count > kMaxChunks;
    const size_t done = isFull ? 0 : addColumns(stack.chunks, kMaxLooked, terrain.shape);
    looked += done;
    if (done < count) leaveOut(terrain, terrain.chunksLeft, count - done, stack.distance);
  }
  joinBlocks(terrain.shape.blocks);
  keepNearest(terrain, distance);
  return terrain;
}

PartDraft partOf(const TerrainBlock& block, InstanceId id, bool solid) {
  constexpr float kStep = kCellSide / kStepsPerCell;
  const auto& row = kTerrainMaterials[std::min<size_t>(block.material - kFirstSolid,
                                                       std::size(kTerrainMaterials) - 1)];
  const Vec3 lo = {float(block.x0) * kCellSide, float(block.bottom) * kStep,
                   float(block.z0) * kCellSide};
  const Vec3 hi = {float(block.x1) * kCellSide, float(block.top) * kStep,
                   float(block.z1) * kCellSide};
  const PhysicalProperties physical = materialProperties(row.material);
  PartDraft part;
  part.id = id;
  part.pose.position = (lo + hi) * 0.5f;
  part.size = hi - lo;
  part.solid = solid;
  part.material = materialName(row.material);
  part.density = physical.density;
  part.friction = physical.friction;
  part.frictionWeight = physical.frictionWeight;
  part.elasticity = physical.elasticity;
  part.color = row.color;
  return part;
}

void noteLosses(const Terrain& terrain, const Tree& tree, InstanceId id, LevelDraft& level) {
  if (terrain.chunksLeft + terrain.blocksLeft > 0)
    level.noteUnmodelled(kTerrainKind, tree, id,
                         fmt::format("the terrain is too large: {} and {} are left out, the "
                                     "nearest {:.0f} studs from the parts",
                                     io::plural(terrain.chunksLeft, "chunk"),
                                     io::plural(terrain.blocksLeft, "block"), terrain.leftFrom));
  if (terrain.shape.slopes > 0)
    level.noteUnmodelled("slope of terrain", tree, id,
                         fmt::format("simulated as steps, at {} places", terrain.shape.slopes));
  if (terrain.shape.water > 0)
    level.noteUnmodelled("water", tree, id,
                         fmt::format("{} cells of terrain hold water: the simulated player falls "
                                     "through it and does not swim",
                                     terrain.shape.water));
}

void addVoxels(const Tree& tree, InstanceId id, std::string_view bytes, LevelDraft& level) {
  auto chunks = voxelChunks(bytes);
  if (!chunks) {
    level.noteUnmodelled(kTerrainKind, tree, id, "left out: " + chunks.error().text());
    return;
  }
  const size_t count = chunks->size();
  const Terrain terrain = shapeOf(*std::move(chunks), level.parts);
  const bool solid = get<bool>(tree.at(id), "CanCollide");
  for (const TerrainBlock& block : terrain.shape.blocks)
    level.parts.push_back(partOf(block, id, solid));
  level.partsRead += uint32_t(terrain.shape.blocks.size());
  if (!terrain.shape.blocks.empty())
    level.noteIgnored(kTerrainKind, tree.path(id),
                      io::plural(count, "chunk") + " of voxels simulated as " +
                          io::plural(terrain.shape.blocks.size(), "block"));
  noteLosses(terrain, tree, id, level);
}

}  // namespace

void addTerrain(const Tree& tree, LevelDraft& level) {
  const InstanceId workspace = tree.service("Workspace");
  if (workspace == kNoInstance) return;
  const InstanceId terrain = tree.childOfClass(workspace, "Terrain");
  if (terrain == kNoInstance) return;
  const std::string_view smooth = voxelBytes(tree.at(terrain), "SmoothGrid");
  if (!smooth.empty()) return addVoxels(tree, terrain, smooth, level);
  for (const char* name : {"ClusterGridV3", "ClusterGridV2", "ClusterGrid"}) {
    const size_t voxels = voxelBytes(tree.at(terrain), name).size();
    if (voxels <= kEmptyTerrain) continue;
    level.noteUnmodelled(kTerrainKind, tree, terrain,
                         std::to_string(voxels) + " bytes of voxels in an old format are left out");
    return;
  }
}

}  // namespace obby::importer
