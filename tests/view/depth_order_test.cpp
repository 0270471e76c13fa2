// Tests that nearer solids are painted after those that they cover.
#include "view/picture/depth_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "view/picture/camera.h"
#include "view/picture/drawn_parts.h"
#include "view/picture/facets.h"

namespace obby::view {
namespace {

Solid slab(Vec3 center, Vec3 half) {
  Solid solid;
  solid.pose.position = center;
  solid.shape.half = half;
  return solid;
}

Paper obliquePaper() {
  const Camera camera = framed({{-50, 0, -50}, {50, 10, 50}}, {0.3f, -0.8f, -1}, 640, 360, false);
  return {camera.right, -camera.up, 5, {-60, -60}};
}

std::vector<Vec2> squareAround(Vec3 center, const Paper& paper) {
  const Vec2 at = paper.of(center);
  return {{at.x - 9, at.y - 9}, {at.x + 9, at.y - 9}, {at.x + 9, at.y + 9}, {at.x - 9, at.y + 9}};
}

// The floor's nearest point is nearer than the block, but the block stands on the floor.
TEST(DepthOrder, ABlockOnALargeFloorIsPaintedAfterIt) {
  const Paper paper = obliquePaper();
  const std::vector<Solid> solids = {slab({0, 2, -40}, {1.5f, 2, 1.5f}),
                                     slab({0, -1, 0}, {50, 1, 50})};
  std::vector<std::vector<Vec2>> outlines;
  for (size_t i = 0; i < solids.size(); ++i) outlines.push_back(squareAround({0, 2, -40}, paper));
  EXPECT_EQ(depthOrder(solids, outlines, paper), (std::vector<size_t>{1, 0}));
  outlines[1].clear();
  EXPECT_EQ(depthOrder(solids, outlines, paper), (std::vector<size_t>{0})) << "outside of the page";
}

TEST(DepthOrder, EachSolidAppearsOnceEvenInARing) {
  const Paper paper = obliquePaper();
  std::vector<Solid> solids;
  std::vector<std::vector<Vec2>> outlines;
  for (int i = 0; i < 9; ++i) {
    solids.push_back(slab({float(i % 3), float(i % 2), float(i)}, {4, 4, 4}));
    outlines.push_back(squareAround(solids.back().pose.position, paper));
  }
  std::vector<size_t> order = depthOrder(solids, outlines, paper);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, (std::vector<size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Facets, AreTheFlatFacesOfEachShape) {
  const auto cornersOf = [](geom::ShapeKind kind) {
    Solid solid = slab({1, 2, 3}, {2, 1, 4});
    solid.kind = kind;
    std::vector<size_t> counts;
    for (const Facet& facet : facetsOf(solid)) {
      counts.push_back(facet.corners.size());
      for (const Vec3 corner : facet.corners)
        EXPECT_GE(dot(corner - solid.pose.position, facet.normal), 0) << "the normal is outward";
    }
    std::sort(counts.begin(), counts.end());
    return counts;
  };
  EXPECT_EQ(cornersOf(geom::ShapeKind::block), (std::vector<size_t>{4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(cornersOf(geom::ShapeKind::wedge), (std::vector<size_t>{3, 3, 4, 4, 4}));
  EXPECT_EQ(cornersOf(geom::ShapeKind::cornerWedge), (std::vector<size_t>{3, 3, 3, 3, 4}));
  EXPECT_TRUE(cornersOf(geom::ShapeKind::ball).empty());
}

}  // namespace
}  // namespace obby::view
