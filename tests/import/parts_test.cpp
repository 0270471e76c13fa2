// Geometry of parts, extent of the level, joints and strays.
#include <cstring>
#include <limits>
#include <memory>

// Included first, so that the importer's names cannot clash with the kinds of values in this
// header.
#include "support/place_columns.h"

#include "import/document/pose_math.h"
#include "import/parts/hulls.h"
#include "import/scene.h"

namespace obby::test {
namespace {

using importer::Shape;

TEST(Parts, EveryClassAndPartTypeHasItsShape) {
  Scene scene;
  const std::pair<uint32_t, Shape> types[] = {{0, Shape::ball},
                                              {1, Shape::block},
                                              {2, Shape::cylinder},
                                              {3, Shape::wedge},
                                              {4, Shape::cornerWedge}};
  std::vector<std::pair<InstanceId, Shape>> made;
  for (const auto& [type, shape] : types) {
    const auto id = scene.part("Part");
    scene.set(id, "Shape", EnumItem{type, {}});
    made.emplace_back(id, shape);
  }
  const std::pair<const char*, Shape> classes[] = {
      {"WedgePart", Shape::wedge},      {"CornerWedgePart", Shape::cornerWedge},
      {"TrussPart", Shape::truss},      {"SpawnLocation", Shape::block},
      {"Seat", Shape::block},           {"VehicleSeat", Shape::block},
      {"UnionOperation", Shape::block}, {"MeshPart", Shape::block}};
  for (const auto& [name, shape] : classes)
    made.emplace_back(scene.part(name, {}, scene.workspace, name), shape);
  scene.level();
  for (const auto& [id, shape] : made) EXPECT_EQ(scene[id].shape, shape) << id;
}

TEST(Parts, MeshWithoutCollisionDataIsItsBoxAndSaysSo) {
  Scene scene;
  const auto mesh = scene.part("Rock", {}, scene.workspace, "MeshPart");
  scene.level();
  EXPECT_EQ(scene.evidence(mesh, "shape").rfind("guessed: bounding box", 0), 0u);
  EXPECT_EQ(scene.unmodelled("shape of a mesh or union"), 1u);
}

// Returns a collision blob of hulls whose corners are (1, 2, 3), without triangles.
std::string collisionBlob(uint32_t hulls, uint32_t corners) {
  std::string bytes = "CSGPHS";
  append(bytes, 3);
  for (uint32_t hull = 0; hull < hulls; ++hull) {
    bytes.append(40, '\0');
    append(bytes, 3 * corners);
    append(bytes, 4);
    for (uint32_t corner = 0; corner < corners; ++corner)
      for (const float f : {1.0f, 2.0f, 3.0f}) appendFloat(bytes, f);
    append(bytes, 0);
  }
  return bytes;
}

TEST(Parts, PartsOverOneBlobHaveItsHullsInTheirOwnSizes) {
  Scene scene;
  const SharedBlob rock{std::make_shared<const std::string>(collisionBlob(2, 5))};
  InstanceId meshes[3];
  for (int i = 0; i < 3; ++i) {
    meshes[i] = scene.part("Rock", {10 * float(i), 0, 0}, scene.workspace, "MeshPart");
    scene.set(meshes[i], "InitialSize", Vec3{4, 1, 4});
    scene.set(meshes[i], "PhysicalConfigData", rock);
  }
  scene.set(meshes[1], "Size", Vec3{8, 1, 4});
  scene.set(meshes[2], "PhysicalConfigData", collisionBlob(1, 4));
  scene.level();
  for (const InstanceId mesh : meshes) {
    EXPECT_EQ(scene[mesh].shape, Shape::hull);
    ASSERT_EQ(scene[mesh].hulls.size(), mesh == meshes[2] ? 1u : 2u);
    EXPECT_EQ(scene[mesh].hulls[0][0], (Vec3{mesh == meshes[1] ? 2.0f : 1.0f, 2, 3}));
  }
  EXPECT_EQ(scene.unmodelled("shape of a mesh or union"), 0u);
}

TEST(Parts, AHullOfTooManyCornersIsTheBoxAroundIt) {
  Scene scene;
  std::string blob = collisionBlob(1, 4) + collisionBlob(1, 300).substr(10);
  const float far = -7;
  std::memcpy(&blob[blob.size() - 8], &far, sizeof far);  // the last corner is (1, 2, -7)
  const auto mesh = scene.part("Rock", {}, scene.workspace, "MeshPart");
  scene.set(mesh, "PhysicalConfigData", blob);
  scene.level();
  EXPECT_EQ(scene[mesh].shape, Shape::hull);
  ASSERT_EQ(scene[mesh].hulls.size(), 2u);
  EXPECT_EQ(scene[mesh].hulls[0].size(), 4u);
  ASSERT_EQ(scene[mesh].hulls[1].size(), 8u);
  EXPECT_EQ(scene[mesh].hulls[1].front(), (Vec3{1, 2, -7}));
  EXPECT_EQ(scene[mesh].hulls[1].back(), (Vec3{1, 2, 3}));
  EXPECT_EQ(
      scene.evidence(mesh, "shape"),
      "guessed: 1 of 2 hulls have more than 255 corners; each of these becomes its bounding box");
  EXPECT_EQ(scene.unmodelled("shape of a mesh or union"), 1u);
}

TEST(Parts, AllHullsOfALevelHaveABudget) {
  constexpr uint32_t kParts = 2000, kHulls = 20, kCorners = 120;
  static_assert(kParts * kHulls * kCorners > importer::kMaxLevelCorners);
  Scene scene;
  const SharedBlob rock{std::make_shared<const std::string>(collisionBlob(kHulls, kCorners))};
  for (uint32_t i = 0; i < kParts; ++i) {
    const auto mesh = scene.part("Rock", {float(i), 0, 0}, scene.workspace, "MeshPart");
    scene.set(mesh, "PhysicalConfigData", rock);
  }
  size_t corners = 0, boxes = 0;
  for (const PartDraft& part : scene.level().parts) {
    boxes += part.shape == Shape::block ? 1 : 0;
    for (const auto& hull : part.hulls) corners += hull.size();
  }
  EXPECT_GT(corners, importer::kMaxLevelCorners / 2);
  EXPECT_LE(corners, importer::kMaxLevelCorners);
  EXPECT_GT(scene.unmodelled("shape of a mesh or union"), 0u);
  EXPECT_EQ(scene.unmodelled("shape of a mesh or union"), boxes);
}

TEST(Parts, OmittedPropertiesHaveTheirClassDefaults) {
  Scene scene;
  const auto id = scene.add("Part", "Bare", scene.workspace);
  scene.level();
  EXPECT_EQ(scene[id].size, (Vec3{4, 1.2f, 2}));
  EXPECT_FALSE(scene[id].anchored);
  EXPECT_TRUE(scene[id].solid);
  EXPECT_TRUE(scene[id].touch);
  EXPECT_FLOAT_EQ(scene[id].friction, 0.3f);
}

TEST(Parts, SurfaceComesFromTheMaterialUnlessThePartHasItsOwn) {
  Scene scene;
  const auto ice = scene.part("Ice"), own = scene.part("Own"), odd = scene.part("Odd");
  scene.set(ice, "Material", EnumItem{1536, {}});
  scene.set(own, "Material", EnumItem{1536, {}});
  scene.set(own, "CustomPhysicalProperties", PhysicalProperties{true, 2, 0.9f, 0.1f, 1, 1});
  scene.set(odd, "Material", EnumItem{4711, {}});
  scene.level();
  EXPECT_FLOAT_EQ(scene[ice].friction, 0.02f);
  EXPECT_FLOAT_EQ(scene[own].friction, 0.9f);
  EXPECT_FLOAT_EQ(scene[own].density, 2);
  EXPECT_FLOAT_EQ(scene[odd].friction, 0.3f);
}

TEST(Parts, MaterialsHaveTheEnginesNames) {
  Scene scene;
  const auto planks = scene.part("Planks"), plain = scene.part("Plain"), odd = scene.part("Odd");
  scene.set(planks, "Material", EnumItem{528, {}});
  scene.set(plain, "Material", EnumItem{256, {}});
  scene.set(odd, "Material", EnumItem{4711, {}});
  scene.level();
  EXPECT_EQ(scene[planks].material, "WoodPlanks");
  EXPECT_EQ(scene[plain].material, "") << "which most are: not worth a word";
  EXPECT_EQ(scene[odd].material, "");
}

TEST(Parts, AReflectionIsRepairedAndCounted) {
  Scene scene;
  const auto id = scene.part("Mirror");
  scene.set(id, "CFrame", CFrame{{1, 2, 3}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  scene.level();
  const Mat3& r = scene[id].pose.rotation;
  EXPECT_NEAR(dot(cross(r.x, r.y), r.z), 1, 1e-6f);
  EXPECT_EQ(r.z, (Vec3{0, 0, 1}));
  EXPECT_EQ(scene.unmodelled("mirrored part"), 1u);
}

TEST(Parts, PartsWithNonFiniteNumbersAreOmitted) {
  Scene scene;
  scene.part("Good");
  const auto bad = scene.part("Bad");
  scene.set(bad, "Size", Vec3{std::numeric_limits<float>::quiet_NaN(), 1, 1});
  EXPECT_EQ(scene.level().parts.size(), 1u);
  EXPECT_EQ(scene.unmodelled("part with an invalid position or size"), 1u);
}

TEST(Scene, OnlyTheWorldCounts) {
  Scene scene;
  scene.part("Floor");
  const auto storage = scene.add("ServerStorage", "ServerStorage", kNoInstance);
  scene.part("Stored", {}, storage);
  const auto rig = scene.add("Model", "Guard", scene.workspace);
  scene.part("Head", {}, rig);
  scene.add("Humanoid", "Humanoid", rig);
  const auto tool = scene.add("Tool", "Sword", scene.workspace);
  scene.part("Handle", {}, tool);
  scene.part("Cut", {}, scene.workspace, "NegateOperation");
  scene.add("Terrain", "Terrain", scene.workspace);
  const auto& level = scene.level();
  ASSERT_EQ(level.parts.size(), 1u);
  EXPECT_EQ(level.partsRead, 1u);
  EXPECT_EQ(level.ignored.at("part in ServerStorage").count, 1u);
  EXPECT_EQ(level.ignored.at("part of a character with a Humanoid").count, 1u);
  EXPECT_EQ(level.ignored.at("part of a tool or accessory").count, 1u);
  EXPECT_EQ(level.ignored.at("NegateOperation").count, 1u);
}

TEST(Scene, RootsOfAModelFileAreTheWorld) {
  Scene scene = Scene::model();
  const auto folder = scene.add("Folder", "Map", kNoInstance);
  scene.part("A", {}, folder);
  scene.part("B", {}, kNoInstance);
  EXPECT_EQ(scene.level().parts.size(), 2u);
}

TEST(Joints, OneAnchoredPartAnchorsItsAssembly) {
  for (const char* kind : {"Weld", "Snap", "ManualWeld", "WeldConstraint", "Glue", "Motor6D"}) {
    Scene scene;
    const auto base = scene.part("Base"), middle = scene.part("Middle"), top = scene.part("Top"),
               dynamic = scene.part("Loose");
    for (const auto id : {middle, top, dynamic}) scene.set(id, "Anchored", false);
    const auto joint = [&](InstanceId a, InstanceId b) {
      const auto id = scene.add(kind, kind, a);
      scene.set(id, "Part0", Ref{a});
      scene.set(id, "Part1", Ref{b});
      return id;
    };
    joint(middle, base);
    const auto second = joint(top, middle);
    scene.level();
    EXPECT_TRUE(scene[middle].anchored) << kind;
    EXPECT_TRUE(scene[top].anchored) << kind;
    EXPECT_FALSE(scene[dynamic].anchored) << kind;
    scene.set(second, "Enabled", false);
    scene.level();
    EXPECT_FALSE(scene[top].anchored) << kind;
  }
}

TEST(Joints, RigidConstraintsJoinThroughTheirAttachments) {
  Scene scene;
  const auto base = scene.part("Base"), arm = scene.part("Arm");
  scene.set(arm, "Anchored", false);
  const auto a0 = scene.add("Attachment", "A0", base), a1 = scene.add("Attachment", "A1", arm);
  const auto joint = scene.add("RigidConstraint", "RigidConstraint", base);
  scene.set(joint, "Attachment0", Ref{a0});
  scene.set(joint, "Attachment1", Ref{a1});
  scene.level();
  EXPECT_TRUE(scene[arm].anchored);
}

TEST(Culling, StraysBelowAndFarAwayAreCounted) {
  Scene scene;
  for (int i = 0; i < 40; ++i) scene.part("Step", {float(i) * 10, 0, 0});
  scene.part("Below", {0, -900, 0});
  scene.part("Far", {0, 2.9e6f, 0});
  scene.part("Outlier", {700, 20, 0});
  const auto& level = scene.level();
  EXPECT_EQ(level.parts.size(), 41u);
  EXPECT_EQ(level.partsRead, 43u);
  EXPECT_EQ(level.partsCulled, 2u);
}

TEST(Culling, AHugeFloorIsNotAStray) {
  Scene scene;
  scene.part("Step");
  const auto floor = scene.part("Floor", {0, -490, 0});
  scene.set(floor, "Size", Vec3{2048, 16, 2048});
  EXPECT_EQ(scene.level().parts.size(), 2u);
}

TEST(PoseMath, QuaternionsAndVectorsOfRotationsAgree) {
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, normalize(Vec3{1, -2, 3})};
  for (const Vec3 axis : axes)
    for (const double angle : {0.1, 1.0, 2.0, 3.1}) {
      const Mat3 m = rotationAbout(axis, angle);
      const Vec3 back = rotationVector(m);
      EXPECT_NEAR(length(back - axis * float(angle)), 0, 2e-5);
      const Mat3 again = toMat3(toQuat(m));
      EXPECT_NEAR(length(again.x - m.x) + length(again.y - m.y) + length(again.z - m.z), 0, 1e-5);
    }
  EXPECT_FLOAT_EQ(importer::yawOf({0, 0, -1}), 0);
  EXPECT_NEAR(importer::yawOf({-1, 0, 0}), 1.5707963f, 1e-6f);
}

}  // namespace
}  // namespace obby::test
