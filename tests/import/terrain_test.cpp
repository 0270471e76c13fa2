// Voxels of smooth terrain as solid blocks.
#include "import/parts/terrain.h"

#include <gmock/gmock.h>

#include <chrono>

#include "import/format/smooth_grid.h"
#include "import/scene.h"
#include "support/voxels.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;

constexpr uint8_t kGrass = 2, kIce = 18;

InstanceId terrainOf(Scene& scene, const std::string& voxels) {
  const InstanceId id = scene.add("Terrain", "Terrain", scene.workspace);
  scene.set(id, "SmoothGrid", voxels);
  return id;
}

std::vector<PartDraft> blocksOf(const LevelDraft& level, InstanceId terrain) {
  std::vector<PartDraft> out;
  for (const PartDraft& part : level.parts)
    if (part.id == terrain) out.push_back(part);
  return out;
}

// Returns true if a point is in one of the blocks.
bool isSolidAt(const std::vector<PartDraft>& blocks, Vec3 at) {
  return std::any_of(blocks.begin(), blocks.end(), [&](const PartDraft& part) {
    const Vec3 d = abs(at - part.pose.position) - part.size * 0.5f;
    return d.x < 0 && d.y < 0 && d.z < 0;
  });
}

Cell groundUnder(int y, int height) { return y < height ? Cell{kGrass, 255} : Cell{}; }

TEST(Terrain, LevelGroundOverManyChunksIsOneBlock) {
  VoxelWriter writer;
  for (int x = -2; x < 2; ++x)
    for (int z = -1; z < 3; ++z)
      writer.chunk({x, -1, z}, [](int, int y, int) { return groundUnder(y, -28); });
  Scene scene;
  const InstanceId id = terrainOf(scene, writer.bytes());
  const auto blocks = blocksOf(scene.level(), id);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0].pose.position, (Vec3{0, -120, 128}));
  EXPECT_EQ(blocks[0].size, (Vec3{512, 16, 512}));
  EXPECT_TRUE(blocks[0].solid && blocks[0].anchored && blocks[0].touch);
  EXPECT_EQ(blocks[0].material, "Grass");
  EXPECT_FLOAT_EQ(blocks[0].friction, 0.4f);
  EXPECT_EQ(scene.unmodelled("terrain"), 0u);
  EXPECT_EQ(scene.unmodelled("slope of terrain"), 0u);
}

TEST(Terrain, TheTopCellGivesTheHeightAcrossChunkBorders) {
  for (const int occupancy : {32, 64, 128, 191, 255}) {
    const auto cell = [&](int, int y, int) {
      return y < 0 ? Cell{kGrass, 255} : y == 0 ? Cell{kGrass, uint8_t(occupancy)} : Cell{};
    };
    Scene scene;
    const InstanceId id =
        terrainOf(scene, VoxelWriter().chunk({0, -1, 0}, cell).chunk({0, 0, 0}, cell).bytes());
    const auto blocks = blocksOf(scene.level(), id);
    ASSERT_EQ(blocks.size(), 1u);
    const float top = blocks[0].pose.position.y + blocks[0].size.y / 2;
    EXPECT_NEAR(top, 4 * float(occupancy) / 255, 0.126f);
    EXPECT_FLOAT_EQ(top - blocks[0].size.y, -128);
  }
}

TEST(Terrain, ThinMatterAloneIsNotSolid) {
  Scene scene;
  const InstanceId id = terrainOf(scene, VoxelWriter()
                                             .chunk({0, 0, 0},
                                                    [](int x, int y, int z) {
                                                      if (x == 3 && y == 3 && z == 3)
                                                        return Cell{kGrass, 100};
                                                      if (x == 9 && y == 9 && z == 9)
                                                        return Cell{kGrass, 191};
                                                      return Cell{};
                                                    })
                                             .bytes());
  const auto blocks = blocksOf(scene.level(), id);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks[0].pose.position, (Vec3{38, 37.5f, 38}));
  EXPECT_EQ(blocks[0].size, (Vec3{4, 3, 4}));
}

TEST(Terrain, CavesHillsAndMaterialsKeepTheirPlaces) {
  const auto solid = [](int x, int y, int z) {
    const bool hill = y < 4 + x / 4;
    const bool cave = z > 10 && z < 14 && y > 0 && y < 3;
    return hill && !cave;
  };
  Scene scene;
  const InstanceId id = terrainOf(
      scene, VoxelWriter()
                 .chunk({0, 0, 0},
                        [&](int x, int y, int z) {
                          return solid(x, y, z) ? Cell{z < 16 ? kGrass : kIce, 255} : Cell{};
                        })
                 .bytes());
  const auto blocks = blocksOf(scene.level(), id);
  EXPECT_LT(blocks.size(), 60u);
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 32; ++y)
      for (int z = 0; z < 32; ++z)
        ASSERT_EQ(isSolidAt(blocks, Vec3{float(x), float(y), float(z)} * 4 + Vec3{2, 2, 2}),
                  solid(x, y, z))
            << x << " " << y << " " << z;
  for (const PartDraft& block : blocks)
    EXPECT_FLOAT_EQ(block.friction, block.pose.position.z < 64 ? 0.4f : 0.02f);
}

TEST(Terrain, SlopesAndWaterAreNamed) {
  Scene scene;
  terrainOf(scene,
            VoxelWriter()
                .chunk({0, 0, 0},
                       [](int x, int y, int) {
                         return y < 8 + x / 8 ? Cell{kGrass, 255} : y < 16 ? Cell{1, 255} : Cell{};
                       })
                .bytes());
  const LevelDraft& level = scene.level();
  EXPECT_EQ(scene.unmodelled("slope of terrain"), 1u);
  ASSERT_EQ(scene.unmodelled("water"), 1u);
  EXPECT_THAT(level.unmodelled.at("water").note, HasSubstr("6656 cells"));
}

TEST(Terrain, TheNearestTerrainIsKeptAboveTheLimit) {
  VoxelWriter writer;  // a chessboard of blocks over 24 chunks: 12,288 blocks a layer
  for (int x = 0; x < 24; ++x)
    writer.chunk({x, 0, 0}, [](int cx, int y, int z) {
      return (cx + z) % 2 == 0 && y % 8 < 4 ? Cell{kGrass, 255} : Cell{};
    });
  Scene scene;
  scene.part("Start", {23 * 128 + 64, 200, 64});
  const InstanceId id = terrainOf(scene, writer.bytes());
  const LevelDraft& level = scene.level();
  const auto blocks = blocksOf(level, id);
  EXPECT_EQ(blocks.size(), kMaxTerrainBlocks);
  EXPECT_TRUE(isSolidAt(blocks, {23 * 128 + 2, 2, 2}));
  EXPECT_FALSE(isSolidAt(blocks, {2, 2, 2}));
  ASSERT_EQ(scene.unmodelled("terrain"), 1u);
  EXPECT_THAT(level.unmodelled.at("terrain").note, HasSubstr("29152 blocks are left out"));
}

TEST(Terrain, WorstCasesEndSoon) {
  VoxelWriter writer;  // alternating heights of alternating cells give the maximum number of pieces
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 4; ++y)
      writer.chunk({x, y, 0}, [](int cx, int cy, int z) {
        return cy % 2 == 0 ? Cell{kGrass, uint8_t(128 + (cx * 7 + z * 3 + cy) % 128)} : Cell{};
      });
  Scene scene;
  const InstanceId id = terrainOf(scene, writer.bytes());
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(blocksOf(scene.level(), id).size(), kMaxTerrainBlocks);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST(SmoothGrid, DamageIsAnError) {
  const std::string good = VoxelWriter()
                               .chunk({-3, 2, 1},
                                      [](int x, int, int) {
                                        return Cell{kGrass, uint8_t(200 + x % 3)};
                                      })
                               .bytes();
  const auto chunks = voxelChunks(good);
  ASSERT_TRUE(chunks);
  ASSERT_EQ(chunks->size(), 1u);
  EXPECT_EQ((*chunks)[0].x, -3);
  EXPECT_EQ((*chunks)[0].y, 2);
  EXPECT_EQ((*chunks)[0].z, 1);
  for (size_t length = 3; length < good.size(); length += 97)
    EXPECT_FALSE(voxelChunks(good.substr(0, length))) << length;
  EXPECT_FALSE(voxelChunks("\1\6"));
  EXPECT_FALSE(voxelChunks(""));
  EXPECT_TRUE(voxelChunks("\1\5")->empty());
  std::string far = good;
  far[2] = 1;  // this chunk is sixteen million chunks away
  EXPECT_FALSE(voxelChunks(far));
}

TEST(SmoothGrid, ShoreCellsHoldMatterAndWater) {
  std::string voxels("\1\5", 2);
  voxels.append(12, '\0');
  // Grass with half occupancy in one cell, and water with a quarter.
  voxels += std::string("\xc2\x80\x00\x40", 4);
  voxels += std::string("\x80\xfe", 2);  // air
  for (int i = 0; i < 127; ++i) voxels += std::string("\x80\xff", 2);
  const auto chunks = voxelChunks(voxels);
  ASSERT_TRUE(chunks) << chunks.error().text();
  Voxels cells;
  readVoxels((*chunks)[0], cells);
  EXPECT_EQ(cells.water, 1u);
  EXPECT_EQ(cells.material[0], kGrass);
  EXPECT_EQ(cells.occupancy[0], 128);
  EXPECT_EQ(cells.material[1], 0);
}

}  // namespace
}  // namespace obby::test
