// Curved faces: compares the separating axes with the body's exact distance to a ball or a
// cylinder.
#include <gtest/gtest.h>

#include "geom/penetration.h"
#include "random_shapes.h"

namespace obby::geom {
namespace {

using test::Dice;

// Returns the point of the shape that is closest to p, in the shape's frame.
Vec3 closestOf(ShapeKind kind, const ShapeData& s, Vec3 p) {
  if (kind == ShapeKind::ball) return p * minf(1.0f, Ball::radius(s) / maxf(length(p), 1e-9f));
  const float shrink = minf(1.0f, Cylinder::radius(s) / maxf(std::hypot(p.y, p.z), 1e-9f));
  return {clampf(p.x, -s.half.x, s.half.x), p.y * shrink, p.z * shrink};
}

// Returns the distance between the box and the shape by converged alternating projections. Both
// bodies are convex, and both projections are exact.
float distanceBetween(ShapeKind kind, const ShapeData& s, const Pose& pose, const UprightBox& box) {
  const Mat3 axes = box.axes();
  const LocalBox local{toLocal(pose, box.center),
                       {toLocal(pose.rotation, axes.x), toLocal(pose.rotation, axes.y),
                        toLocal(pose.rotation, axes.z)},
                       box.half};
  Vec3 onShape{}, onBox{};
  for (int i = 0; i < 1000; ++i) {
    onBox = closestPoint(local, onShape);
    onShape = closestOf(kind, s, onBox);
  }
  return length(onBox - onShape);
}

// Returns the largest distance at which a pair was still reported as overlapping.
float worstFalseContact(ShapeKind kind, uint64_t stream) {
  Dice dice(stream);
  float worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const ShapeData s{dice.half(), nullptr};
    const Pose pose{dice.vec(2), dice.rotation()};
    const UprightBox box = dice.body(4);
    const float d = distanceBetween(kind, s, pose, box);
    const Contact c = penetration(kind, s, pose, box);
    if (d == 0 && c.depth < -2e-4f) ADD_FAILURE() << "overlap called apart by " << c.depth;
    if (c.depth >= 0) worst = maxf(worst, d);
  }
  return worst;
}

TEST(RoundShapes, ABallIsApartIffItsDistanceIsPositive) {
  EXPECT_LT(worstFalseContact(ShapeKind::ball, 400), 1e-3f);
}

// No axis separates a rim from a corner or edge of the body, so contact may come too early there.
TEST(RoundShapes, ACylinderIsApartWithinAHalfStudOfItsRim) {
  EXPECT_LT(worstFalseContact(ShapeKind::cylinder, 401), 0.5f);
}

TEST(RoundShapes, TheDepthOfABallFollowsTheDistanceOfItsCentre) {
  const ShapeData s{{1, 1, 1}, nullptr};
  const UprightBox box{{0, 0, 0}, {1, 1, 0.5f}, sinCos(0)};
  const Contact side = penetration(ShapeKind::ball, s, {{1.9f, 0, 0}, {}}, box);
  EXPECT_NEAR(side.depth, 0.1f, 1e-5f);
  EXPECT_NEAR(side.normal.x, -1, 1e-5f);
  const Contact corner = penetration(ShapeKind::ball, s, {{1.5f, 1.5f, 1.0f}, {}}, box);
  EXPECT_NEAR(corner.depth, 1 - std::sqrt(0.75f), 1e-5f);
  EXPECT_LT(penetration(ShapeKind::ball, s, {{1.6f, 1.6f, 1.1f}, {}}, box).depth, 0);
}

TEST(RoundShapes, AStandingCylinderIsRoundFromTheSide) {
  // The cylinder stands upright: its local X is the world's Y.
  const Pose upright{{0, 0, 0}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  const ShapeData s{{3, 1, 1}, nullptr};
  const float diagonal = std::sqrt(0.5f);
  const UprightBox near{{1 + diagonal - 0.05f, 0, 1 + diagonal - 0.05f}, {1, 1, 1}, sinCos(0)};
  const UprightBox far{{1 + diagonal + 0.01f, 0, 1 + diagonal + 0.01f}, {1, 1, 1}, sinCos(0)};
  EXPECT_NEAR(penetration(ShapeKind::cylinder, s, upright, near).depth, 0.05f / diagonal, 1e-4f);
  EXPECT_LT(penetration(ShapeKind::cylinder, s, upright, far).depth, 0);
}

}  // namespace
}  // namespace obby::geom
