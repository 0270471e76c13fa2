// Faces and contacts of hulls that do not contain their part's centre, as in unions.
#include "geom/hull_face.h"

#include <gtest/gtest.h>

#include "geom/manifold.h"

namespace obby::geom {
namespace {

// The hull tables of a box.
struct BoxHull {
  Vec3 vertices[8];
  Vec3 normals[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  float offsets[6];
  Vec3 edges[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

  BoxHull(Vec3 center, Vec3 half) {
    for (int i = 0; i < 8; ++i) {
      const Vec3 side{i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f};
      vertices[i] = center + mul(side, half);
    }
    for (int f = 0; f < 6; ++f) offsets[f] = dot(normals[f], center) + dot(abs(normals[f]), half);
  }
  Hull hull() const { return {vertices, normals, offsets, edges, 8, 6, 3}; }
};

// The part's centre is 190 studs above the slab's top face.
BoxHull slab() { return {{0, -195, 0}, {200, 5, 200}}; }

Convex restingOn(ShapeKind kind) { return {kind, {{1, 1, 1}, nullptr}, {{3, -189, 2}, {}}}; }
Convex convexOf(const Hull& hull) { return {ShapeKind::hull, {{200, 200, 200}, &hull}, {}}; }

TEST(HullFace, HasItsCornersForAnyCentre) {
  const BoxHull box = slab();
  for (int f = 0; f < 6; ++f) {
    Vec3 corners[kMaxFeature];
    ASSERT_EQ(hullFace(box.hull(), box.normals[f], corners), 4) << f;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(dot(box.normals[f], corners[i]), box.offsets[f]) << f;
  }
}

TEST(HullFace, IsTouchedInItsPlane) {
  const BoxHull box = slab();
  const Hull hull = box.hull();
  const Convex below = convexOf(hull);
  for (const ShapeKind kind : {ShapeKind::block, ShapeKind::ball}) {
    const Convex above = restingOn(kind);
    const Separation s = separation(above, below, 0.1f);
    const Manifold m = manifold(above, below, s, 0.1f);
    EXPECT_NEAR(m.normal.y, -1, 1e-6f);
    ASSERT_EQ(m.count, kind == ShapeKind::block ? 4 : 1);
    for (int i = 0; i < m.count; ++i) EXPECT_NEAR(m.points[i].position.y, -190, 1e-3f);
  }
}

TEST(HullFace, AFaceWithoutCornersHasNoPoints) {
  BoxHull box = slab();
  box.offsets[2] += 100;
  const Hull hull = box.hull();
  const Convex below = convexOf(hull);
  for (const ShapeKind kind : {ShapeKind::block, ShapeKind::ball}) {
    const Convex above = restingOn(kind);
    const Separation s = separation(above, below, 0.1f);
    EXPECT_EQ(manifold(above, below, s, 0.1f).count, 0);
    EXPECT_EQ(manifold(below, above, {s.distance, -s.normal}, 0.1f).count, 0);
  }
}

}  // namespace
}  // namespace obby::geom
