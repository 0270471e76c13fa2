// The name, density, friction and elasticity of each material, as documented for the engine.
#include "engine/values/materials.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace obby {
namespace {

struct Row {
  uint32_t material;
  std::string_view name;
  float density, friction, elasticity, frictionWeight, elasticityWeight;
};

// Sorted by material.
constexpr std::array<Row, 43> kRows = {{
    {256, "Plastic", 0.7f, 0.3f, 0.5f, 1, 1},
    {272, "SmoothPlastic", 0.7f, 0.2f, 0.5f, 1, 1},
    {288, "Neon", 0.7f, 0.3f, 0.2f, 1, 1},
    {512, "Wood", 0.35f, 0.48f, 0.2f, 1, 1},
    {528, "WoodPlanks", 0.35f, 0.48f, 0.2f, 1, 1},
    {784, "Marble", 2.563f, 0.2f, 0.17f, 1, 1},
    {788, "Basalt", 2.691f, 0.7f, 0.15f, 0.3f, 1},
    {800, "Slate", 2.691f, 0.4f, 0.2f, 1, 1},
    {804, "CrackedLava", 2.691f, 0.65f, 0.15f, 1, 1},
    {816, "Concrete", 2.403f, 0.7f, 0.2f, 0.3f, 1},
    {820, "Limestone", 2.691f, 0.5f, 0.15f, 1, 1},
    {832, "Granite", 2.691f, 0.4f, 0.2f, 1, 1},
    {836, "Pavement", 2.691f, 0.5f, 0.17f, 0.3f, 1},
    {848, "Brick", 1.922f, 0.8f, 0.15f, 0.3f, 1},
    {864, "Pebble", 2.403f, 0.4f, 0.17f, 1, 1.5f},
    {880, "Cobblestone", 2.691f, 0.5f, 0.17f, 1, 1},
    {896, "Rock", 2.691f, 0.5f, 0.17f, 1, 1},
    {912, "Sandstone", 2.691f, 0.5f, 0.15f, 5, 1},
    {1040, "CorrodedMetal", 7.85f, 0.7f, 0.2f, 1, 1},
    {1056, "DiamondPlate", 7.85f, 0.35f, 0.25f, 1, 1},
    {1072, "Foil", 2.7f, 0.4f, 0.25f, 1, 1},
    {1088, "Metal", 7.85f, 0.4f, 0.25f, 1, 1},
    {1280, "Grass", 0.9f, 0.4f, 0.1f, 1, 1.5f},
    {1284, "LeafyGrass", 0.9f, 0.4f, 0.1f, 2, 2},
    {1296, "Sand", 1.602f, 0.5f, 0.05f, 5, 2.5f},
    {1312, "Fabric", 0.7f, 0.35f, 0.05f, 1, 1},
    {1328, "Snow", 0.9f, 0.3f, 0.03f, 3, 4},
    {1344, "Mud", 0.9f, 0.3f, 0.07f, 3, 4},
    {1360, "Ground", 0.9f, 0.45f, 0.1f, 1, 1},
    {1376, "Asphalt", 2.36f, 0.8f, 0.2f, 0.3f, 1},
    {1392, "Salt", 2.165f, 0.5f, 0.05f, 1, 1},
    {1536, "Ice", 0.919f, 0.02f, 0.15f, 3, 1},
    {1552, "Glacier", 0.919f, 0.05f, 0.15f, 2, 1},
    {1568, "Glass", 2.403f, 0.25f, 0.2f, 1, 1},
    {1584, "ForceField", 2.403f, 0.25f, 0.2f, 1, 1},
    {2304, "Cardboard", 0.7f, 0.5f, 0.05f, 1, 2},
    {2305, "Carpet", 1.1f, 0.4f, 0.25f, 1, 2},
    {2306, "CeramicTiles", 2.4f, 0.51f, 0.2f, 1, 1},
    {2307, "ClayRoofTiles", 2, 0.51f, 0.2f, 1, 1},
    {2308, "RoofShingles", 2.36f, 0.8f, 0.2f, 0.3f, 1},
    {2309, "Leather", 0.86f, 0.35f, 0.25f, 1, 1},
    {2310, "Plaster", 0.75f, 0.6f, 0.2f, 0.3f, 1},
    {2311, "Rubber", 1.3f, 1.5f, 0.95f, 3, 2},
}};
constexpr uint32_t kPlastic = 256;

const Row& rowOf(uint32_t material) {
  const auto it = std::lower_bound(kRows.begin(), kRows.end(), material,
                                   [](const Row& row, uint32_t v) { return row.material < v; });
  return it == kRows.end() || it->material != material ? rowOf(kPlastic) : *it;
}

}  // namespace

PhysicalProperties materialProperties(uint32_t material) {
  const Row& row = rowOf(material);
  return {false,          row.density,        row.friction,
          row.elasticity, row.frictionWeight, row.elasticityWeight};
}

std::optional<uint32_t> materialNamed(std::string_view name) {
  for (const Row& row : kRows)
    if (row.name == name) return row.material;
  return {};
}

std::string_view materialName(uint32_t material) {
  const Row& row = rowOf(material);
  return row.material == kPlastic ? std::string_view() : row.name;
}

}  // namespace obby
