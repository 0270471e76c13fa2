// Collision hulls of unions and mesh parts.
#include "import/format/csg_physics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "import/parts/hulls.h"
#include "support/place_columns.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;

// Returns the bytes of a hull: a tetrahedron with four corners and four triangles in the box of
// half size `reach`.
std::string hull(float reach = 1) {
  std::string out(40, '\0');
  append(out, 12);
  append(out, 4);
  for (const Vec3 v : {Vec3{-1, -1, -1}, Vec3{1, -1, -1}, Vec3{0, 1, -1}, Vec3{0, 0, 1}}) {
    for (const float f : {v.x * reach, v.y * reach, v.z * reach}) appendFloat(out, f);
  }
  append(out, 12);
  for (const uint32_t i : {0u, 1u, 2u, 0u, 1u, 3u, 1u, 2u, 3u, 0u, 2u, 3u}) append(out, i);
  return out;
}
std::string csg(uint32_t version, const std::string& body) {
  std::string out = "CSGPHS";
  append(out, version);
  return out + body;
}

TEST(CsgPhysics, HullsOfAllPlainVersionsAreRead) {
  const std::string mass(40, '\0');
  for (const std::string& blob :
       {csg(3, hull() + hull()), csg(5, hull() + hull()), csg(6, mass + hull() + hull()),
        csg(7, "\x02" + mass + hull() + hull())}) {
    const Result<Collision> collision = decodeCollision(blob);
    ASSERT_TRUE(collision) << collision.error().text();
    EXPECT_EQ(collision->kind, CollisionKind::Hulls);
    ASSERT_EQ(collision->hulls.size(), 2u);
    EXPECT_EQ(collision->hulls[1].size(), 4u);
    EXPECT_EQ(collision->hulls[1][3], (Vec3{0, 0, 1}));
  }
}

TEST(CsgPhysics, BoxesAndUnknownVersionsAreDistinguished) {
  EXPECT_EQ(decodeCollision("")->kind, CollisionKind::Absent);
  EXPECT_EQ(decodeCollision(csg(0, "BLOCK"))->kind, CollisionKind::Box);
  const Result<Collision> unknown = decodeCollision(csg(9, "whatever"));
  EXPECT_EQ(unknown->kind, CollisionKind::Unsupported);
  EXPECT_EQ(unknown->detail, "CSGPHS 9 is not supported");
  EXPECT_EQ(decodeCollision("CSGK0123456789abcdef")->kind, CollisionKind::Unsupported);
  EXPECT_EQ(decodeCollision(csg(5, ""))->kind, CollisionKind::Unsupported);
}

TEST(CsgPhysics, EveryTruncationIsAnErrorOrHasFewerHulls) {
  const std::string blob = csg(5, hull() + hull());
  for (size_t length = 1; length < blob.size(); ++length) {
    const Result<Collision> collision = decodeCollision(std::string_view(blob).substr(0, length));
    if (collision) {
      EXPECT_LT(collision->hulls.size(), 2u) << length;
    }
  }
}

TEST(CsgPhysics, WrongCountsIndicesAndNumbersAreErrors) {
  std::string bad = hull();
  bad[40] = 13;  // the number of floats is not a multiple of three
  EXPECT_FALSE(decodeCollision(csg(5, bad)));
  bad = hull();
  bad[43] = '\x7f';  // two billion floats
  EXPECT_FALSE(decodeCollision(csg(5, bad)));
  bad = hull();
  bad[bad.size() - 1] = 1;  // an index far beyond the vertices
  EXPECT_FALSE(decodeCollision(csg(5, bad)));
  bad = hull();
  bad.replace(48, 4, std::string("\0\0\x80\x7f", 4));  // infinity
  EXPECT_FALSE(decodeCollision(csg(5, bad)));
}

TEST(CsgPhysics, CornersAreScaledToTheSizeOfThePart) {
  Instance part;
  part.className = "UnionOperation";
  part.properties["Size"] = Vec3{4, 2, 1};
  part.properties["InitialSize"] = Vec3{2, 2, 2};
  part.properties["PhysicalConfigData"] =
      SharedBlob{std::make_shared<const std::string>(csg(5, hull()))};
  const Collision collision = collisionFrom(collisionBlobOf(part));
  ASSERT_EQ(collision.kind, CollisionKind::Hulls);
  const auto hulls = scaledHulls(collision.hulls, hullScaleOf(part));
  ASSERT_EQ(hulls.size(), 1u);
  EXPECT_EQ(hulls[0][0], (Vec3{-2, -1, -0.5f}));
}

TEST(CsgPhysics, HullsScaledOutOfBoundsAreOmitted) {
  const std::vector<Vec3> small = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  std::vector<Vec3> wide = small;
  wide[0].x = 1e30f;
  const auto hulls = scaledHulls({wide, small}, {1e5f, 2, 1});
  ASSERT_EQ(hulls.size(), 1u);
  EXPECT_EQ(hulls[0][1], (Vec3{0, 2, 0}));
  // The scaled hull is finite but beyond the bounds of a level. It would make the whole level
  // invalid.
  EXPECT_EQ(scaledHulls({small}, {1, 999999, 1}).size(), 1u);
  EXPECT_EQ(scaledHulls({small}, {1, 2e6f, 1}).size(), 0u);
}

TEST(CsgPhysics, OldDataReplacesMissingDataAndDamageIsReported) {
  Instance part;
  part.className = "MeshPart";
  const auto collision = [&] { return collisionFrom(collisionBlobOf(part)); };
  EXPECT_EQ(collision().kind, CollisionKind::Absent);
  part.properties["PhysicalConfigData"] = std::string();
  part.properties["PhysicsData"] = csg(0, "BLOCK");
  EXPECT_EQ(collision().kind, CollisionKind::Box);
  part.properties["PhysicsData"] = std::string("CSGPHS");
  EXPECT_EQ(collision().kind, CollisionKind::Unsupported);
  EXPECT_THAT(collision().detail, HasSubstr("PhysicsData: byte"));
}

}  // namespace
}  // namespace obby::test
