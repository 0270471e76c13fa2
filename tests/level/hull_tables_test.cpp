// Face and edge tables of convex hulls match those of known solids.
#include "level/hull_tables.h"

#include <gtest/gtest.h>

#include "base/random.h"
#include "geom/penetration.h"
#include "geom/shapes/convex_hull.h"
#include "support/level_builder.h"

namespace obby::level {
namespace {

using geom::ShapeData;
using geom::ShapeKind;

struct HullTablesDice {
  Random random;
  float number(float size) { return (2 * random.unit() - 1) * size; }
  Vec3 vec(float size) { return {number(size), number(size), number(size)}; }
  Mat3 rotation() {
    return toMat3(normalize(Quat{number(1), number(1), number(1), 0.1f + random.unit()}));
  }
};

std::vector<Vec3> boxCorners(Vec3 half) {
  std::vector<Vec3> out;
  for (int c = 0; c < 8; ++c)
    out.push_back(mul(half, {c & 1 ? 1.f : -1.f, c & 2 ? 1.f : -1.f, c & 4 ? 1.f : -1.f}));
  return out;
}

// Compares contacts of random bodies with the hull and with the solid that it represents.
void expectSameSolid(const HullTables& tables, ShapeKind kind, Vec3 half) {
  HullTablesDice dice{Random(9, uint64_t(kind))};
  const geom::Hull hull = viewOf(tables);
  const ShapeData solid{half, nullptr}, asHull{half, &hull};
  for (int i = 0; i < 20000; ++i) {
    const Pose pose{dice.vec(2), dice.rotation()};
    const geom::UprightBox box{dice.vec(2), {1, 1.5f, 0.5f}, sinCos(Turns(dice.random.next()))};
    const auto a = penetration(kind, solid, pose, box);
    const auto b = penetration(ShapeKind::hull, asHull, pose, box);
    if (absf(a.depth) < 1e-3f) continue;
    ASSERT_EQ(a.depth >= 0, b.depth >= 0);
    if (a.depth >= 0) {
      ASSERT_NEAR(a.depth, b.depth, 1e-3f);
    }
  }
}

TEST(HullTables, ABoxEqualsTheBlock) {
  const Vec3 half{2, 1, 0.5f};
  const HullTables t = hullTables(boxCorners(half));
  EXPECT_EQ(t.vertices.size(), 8u);
  EXPECT_EQ(t.normals.size(), 6u);
  EXPECT_EQ(t.edges.size(), 3u);
  expectSameSolid(t, ShapeKind::block, half);
}

// Expects that the box corners selected by `keep` form the solid of this kind, with five faces.
void expectSolidOf(ShapeKind kind, const std::function<bool(Vec3)>& keep) {
  const Vec3 half{2, 1, 1.5f};
  std::vector<Vec3> corners;
  for (const Vec3 p : boxCorners(half)) {
    if (keep(p)) corners.push_back(p);
  }
  const HullTables t = hullTables(corners);
  EXPECT_EQ(t.normals.size(), 5u);
  expectSameSolid(t, kind, half);
}

TEST(HullTables, WedgeCornersGiveTheWedge) {
  expectSolidOf(ShapeKind::wedge, [](Vec3 p) { return p.y < 0 || p.z > 0; });
}

TEST(HullTables, CornerWedgeCornersGiveTheCornerWedge) {
  expectSolidOf(ShapeKind::cornerWedge, [](Vec3 p) { return p.y < 0 || (p.x > 0 && p.z < 0); });
}

TEST(HullTables, IgnoreRepeatedAndInnerVertices) {
  auto corners = boxCorners({1, 1, 1});
  const auto again = corners;
  corners.insert(corners.end(), again.begin(), again.end());
  for (const Vec3 p : again) corners.push_back(p * 0.5f);
  const HullTables t = hullTables(corners);
  EXPECT_EQ(t.normals.size(), 6u);
  EXPECT_EQ(t.edges.size(), 3u);
}

TEST(HullTables, AreEmptyForFlatOrThinSets) {
  EXPECT_TRUE(hullTables({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}).normals.empty());
  EXPECT_TRUE(hullTables({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).normals.empty());
  EXPECT_TRUE(hullTables({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).normals.empty());
}

// A floor that is 8000 times as wide as thick, a plank and a rope all have six faces and eight
// corners.
TEST(HullTables, ThinAndWideBoxesEqualTheBlock) {
  for (const Vec3 half :
       {Vec3{200, 0.025f, 200}, Vec3{1000, 0.05f, 3}, Vec3{300, 0.025f, 0.025f}}) {
    const HullTables t = hullTables(boxCorners(half));
    EXPECT_EQ(t.vertices.size(), 8u) << half.x;
    EXPECT_EQ(t.normals.size(), 6u) << half.x;
    EXPECT_EQ(t.edges.size(), 3u) << half.x;
    Vec3 seen{};  // the number of faces along each axis
    for (size_t f = 0; f < t.normals.size(); ++f) {
      const Vec3 n = abs(t.normals[f]);
      seen += Vec3{n.x > 0.999f ? 1.f : 0.f, n.y > 0.999f ? 1.f : 0.f, n.z > 0.999f ? 1.f : 0.f};
      EXPECT_NEAR(t.offsets[f], dot(n, half), 1e-3f) << half.x;
    }
    EXPECT_TRUE(seen == (Vec3{2, 2, 2})) << half.x;
  }
}

// Whatever the rotation, rays hit the floor everywhere within its borders and nowhere outside.
TEST(HullTables, AThinFloorStopsRaysWithinItsBordersOnly) {
  HullTablesDice dice{Random(12, 0)};
  for (int round = 0; round < 20; ++round) {
    const Mat3 axes = dice.rotation();
    const Vec3 at = dice.vec(30);
    std::vector<Vec3> corners = boxCorners({200, 0.025f, 200});
    for (Vec3& p : corners) p = axes * p + at;
    const HullTables t = hullTables(corners);
    ASSERT_GE(t.normals.size(), 6u);
    const geom::Hull hull = viewOf(t);
    const ShapeData shape{{300, 300, 300}, &hull};
    const auto hits = [&](float x, float z, geom::RayHit& hit) {
      return geom::ConvexHull::castRay(shape, axes * Vec3{x, 5, z} + at, axes * Vec3{0, -10, 0}, 1,
                                       hit);
    };
    for (int i = 0; i < 100; ++i) {
      geom::RayHit hit{};
      const float along = dice.number(199);
      ASSERT_TRUE(hits(along, dice.number(199), hit)) << round;
      EXPECT_NEAR(hit.t, 0.4975f, 1e-3f);
      EXPECT_GT(dot(hit.normal, axes.y), 0.999f);
      EXPECT_FALSE(hits(202, along, hit) || hits(-202, along, hit)) << round;
      EXPECT_FALSE(hits(along, 202, hit) || hits(along, -202, hit)) << round;
    }
  }
}

TEST(HullTables, AreEmptyForRoundingSliversOfAUnion) {
  EXPECT_TRUE(hullTables(boxCorners({200, 0.002f, 200})).normals.empty());
  EXPECT_TRUE(hullTables(boxCorners({1, 0.00004f, 1})).normals.empty());
  HullTablesDice dice{Random(13, 0)};
  std::vector<Vec3> flat = boxCorners({200, 0, 200});
  const Mat3 axes = dice.rotation();
  for (Vec3& p : flat) p = axes * p;
  EXPECT_TRUE(hullTables(flat).normals.empty());
}

TEST(HullTables, FacesHoldAllVerticesAndTouchThree) {
  HullTablesDice dice{Random(10, 0)};
  for (int round = 0; round < 60; ++round) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4 + round % 20; ++i) points.push_back(dice.vec(3));
    const HullTables t = hullTables(points);
    ASSERT_EQ(t.normals.size(), t.offsets.size());
    ASSERT_GE(t.normals.size(), 4u);
    for (size_t f = 0; f < t.normals.size(); ++f) {
      int on = 0;
      for (const Vec3 p : points) {
        ASSERT_LE(dot(t.normals[f], p), t.offsets[f] + 2e-3f);
        on += dot(t.normals[f], p) > t.offsets[f] - 2e-3f;
      }
      ASSERT_GE(on, 3);
    }
  }
}

TEST(HullTables, ManyVerticesOnASphereApproximateTheBall) {
  HullTablesDice dice{Random(11, 0)};
  std::vector<Vec3> points;
  for (size_t i = 0; i < 120; ++i) points.push_back(normalize(dice.vec(1)) * 2);
  const HullTables t = hullTables(points);
  EXPECT_TRUE(t.edges.empty()) << "faces alone describe a nearly round hull";
  for (const float offset : t.offsets) {
    EXPECT_LE(offset, 2.001f);
    EXPECT_GT(offset, 1.5f);
  }
}

TEST(CompiledHulls, CopiesOfOneMeshShareItsTables) {
  support::LevelBuilder b;
  for (int copy = 0; copy < 3; ++copy) {
    b.part([=](auto p) {
      p.setShape(schema::Shape::HULL);
      support::set(p.initPosition(), {float(10 * copy), 0, 0});
      auto vertices = p.initHulls(1)[0].initVertices(8);
      const auto corners = boxCorners({1, 2, copy < 2 ? 3.0f : 4.0f});
      for (uint32_t i = 0; i < 8; ++i) support::set(vertices[i], corners[i]);
    });
  }
  const Level level = b.compile();
  const LevelView& v = level.view();
  ASSERT_EQ(v.colliderCount, 3u);
  EXPECT_EQ(v.colliders[0].shape.hull, v.colliders[1].shape.hull);
  EXPECT_NE(v.colliders[0].shape.hull, v.colliders[2].shape.hull);
  EXPECT_EQ(v.colliders[1].shape.half.z, 3);
  EXPECT_EQ(v.colliders[2].shape.half.z, 4);
}

TEST(CompiledHulls, ThinAndWideHullsStay) {
  support::LevelBuilder b;
  b.part([](auto p) {
    p.setShape(schema::Shape::HULL);
    support::set(p.initSize(), {400, 0.05f, 400});
    auto vertices = p.initHulls(1)[0].initVertices(8);
    const auto corners = boxCorners({200, 0.025f, 200});
    for (uint32_t i = 0; i < 8; ++i) support::set(vertices[i], corners[i]);
  });
  const Level level = b.compile();
  ASSERT_EQ(level.view().colliderCount, 1u);
  EXPECT_EQ(level.view().colliders[0].shape.half.x, 200);
}

// A mesh without thickness is still a floor, since the part has no other geometry.
TEST(CompiledHulls, APartOfFlatHullsGetsTheEnginesMinimumThickness) {
  support::LevelBuilder b;
  b.part([](auto p) {
    p.setShape(schema::Shape::HULL);
    auto hulls = p.initHulls(3);
    auto floor = hulls[0].initVertices(4), line = hulls[1].initVertices(4);
    auto slanted = hulls[2].initVertices(4);
    for (uint32_t i = 0; i < 4; ++i) {
      const float x = i & 1 ? 5.f : -5.f, z = i & 2 ? 5.f : -5.f;
      support::set(floor[i], {x, 1, z});
      support::set(line[i], {float(i), 0, 0});
      support::set(slanted[i], {x, x, z});
    }
  });
  const Level level = b.compile();
  ASSERT_EQ(level.view().colliderCount, 1u);
  const geom::Hull& hull = *level.view().colliders[0].shape.hull;
  EXPECT_EQ(hull.faceCount, 6u);
  for (uint32_t i = 0; i < hull.vertexCount; ++i) {
    EXPECT_NEAR(absf(hull.vertices[i].y - 1), 0.025f, 1e-6f);
  }
}

TEST(CompiledHulls, FlatHullsAreLeftOutOfTheBounds) {
  support::LevelBuilder b;
  b.part([](auto p) {
    p.setShape(schema::Shape::HULL);
    support::set(p.initPosition(), {10, 0, 0});
    auto hulls = p.initHulls(2);
    auto flat = hulls[0].initVertices(4), solid = hulls[1].initVertices(8);
    for (uint32_t i = 0; i < 4; ++i) support::set(flat[i], {float(i & 1), 0, float(i >> 1)});
    const auto corners = boxCorners({1, 2, 3});
    for (uint32_t i = 0; i < 8; ++i) support::set(solid[i], corners[i] + Vec3{0, 4, 0});
  });
  const Level level = b.compile();
  ASSERT_EQ(level.view().colliderCount, 1u);
  const Box box = level.view().bounds[0].box();
  EXPECT_TRUE(box.lo.x <= 9 && box.hi.x >= 11 && box.hi.y >= 6 && box.hi.z >= 3);
}

}  // namespace
}  // namespace obby::level
