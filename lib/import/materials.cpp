// Density, friction and elasticity of each material, as documented for the engine.
#include "import/materials.h"

#include <algorithm>
#include <array>

namespace obby::importer {
namespace {

struct Row {
  uint32_t material;
  float density, friction, elasticity, frictionWeight, elasticityWeight;
};

// Sorted by material.
constexpr std::array<Row, 43> kRows = {{
    {256, 0.7f, 0.3f, 0.5f, 1, 1},         // Plastic
    {272, 0.7f, 0.2f, 0.5f, 1, 1},         // SmoothPlastic
    {288, 0.7f, 0.3f, 0.2f, 1, 1},         // Neon
    {512, 0.35f, 0.48f, 0.2f, 1, 1},       // Wood
    {528, 0.35f, 0.48f, 0.2f, 1, 1},       // WoodPlanks
    {784, 2.563f, 0.2f, 0.17f, 1, 1},      // Marble
    {788, 2.691f, 0.7f, 0.15f, 0.3f, 1},   // Basalt
    {800, 2.691f, 0.4f, 0.2f, 1, 1},       // Slate
    {804, 2.691f, 0.65f, 0.15f, 1, 1},     // CrackedLava
    {816, 2.403f, 0.7f, 0.2f, 0.3f, 1},    // Concrete
    {820, 2.691f, 0.5f, 0.15f, 1, 1},      // Limestone
    {832, 2.691f, 0.4f, 0.2f, 1, 1},       // Granite
    {836, 2.691f, 0.5f, 0.17f, 0.3f, 1},   // Pavement
    {848, 1.922f, 0.8f, 0.15f, 0.3f, 1},   // Brick
    {864, 2.403f, 0.4f, 0.17f, 1, 1.5f},   // Pebble
    {880, 2.691f, 0.5f, 0.17f, 1, 1},      // Cobblestone
    {896, 2.691f, 0.5f, 0.17f, 1, 1},      // Rock
    {912, 2.691f, 0.5f, 0.15f, 5, 1},      // Sandstone
    {1040, 7.85f, 0.7f, 0.2f, 1, 1},       // CorrodedMetal
    {1056, 7.85f, 0.35f, 0.25f, 1, 1},     // DiamondPlate
    {1072, 2.7f, 0.4f, 0.25f, 1, 1},       // Foil
    {1088, 7.85f, 0.4f, 0.25f, 1, 1},      // Metal
    {1280, 0.9f, 0.4f, 0.1f, 1, 1.5f},     // Grass
    {1284, 0.9f, 0.4f, 0.1f, 2, 2},        // LeafyGrass
    {1296, 1.602f, 0.5f, 0.05f, 5, 2.5f},  // Sand
    {1312, 0.7f, 0.35f, 0.05f, 1, 1},      // Fabric
    {1328, 0.9f, 0.3f, 0.03f, 3, 4},       // Snow
    {1344, 0.9f, 0.3f, 0.07f, 3, 4},       // Mud
    {1360, 0.9f, 0.45f, 0.1f, 1, 1},       // Ground
    {1376, 2.36f, 0.8f, 0.2f, 0.3f, 1},    // Asphalt
    {1392, 2.165f, 0.5f, 0.05f, 1, 1},     // Salt
    {1536, 0.919f, 0.02f, 0.15f, 3, 1},    // Ice
    {1552, 0.919f, 0.05f, 0.15f, 2, 1},    // Glacier
    {1568, 2.403f, 0.25f, 0.2f, 1, 1},     // Glass
    {1584, 2.403f, 0.25f, 0.2f, 1, 1},     // ForceField
    {2304, 0.7f, 0.5f, 0.05f, 1, 2},       // Cardboard
    {2305, 1.1f, 0.4f, 0.25f, 1, 2},       // Carpet
    {2306, 2.4f, 0.51f, 0.2f, 1, 1},       // CeramicTiles
    {2307, 2, 0.51f, 0.2f, 1, 1},          // ClayRoofTiles
    {2308, 2.36f, 0.8f, 0.2f, 0.3f, 1},    // RoofShingles
    {2309, 0.86f, 0.35f, 0.25f, 1, 1},     // Leather
    {2310, 0.75f, 0.6f, 0.2f, 0.3f, 1},    // Plaster
    {2311, 1.3f, 1.5f, 0.95f, 3, 2},       // Rubber
}};
constexpr uint32_t kPlastic = 256;

}  // namespace

PhysicalProperties materialProperties(uint32_t material) {
  const auto find = [](uint32_t value) {
    return std::lower_bound(kRows.begin(), kRows.end(), value,
                            [](const Row& row, uint32_t v) { return row.material < v; });
  };
  auto it = find(material);
  if (it == kRows.end() || it->material != material) it = find(kPlastic);
  return {false,          it->density,        it->friction,
          it->elasticity, it->frictionWeight, it->elasticityWeight};
}

}  // namespace obby::importer
