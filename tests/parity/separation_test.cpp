// geom::separation over all pairs of kinds. The references are exact separating axes for polytopes,
// exact distances of a ball's centre, and Bullet's GJK and EPA for cylinders. separation() prefers
// faces by up to kPreference, so it may be too deep by that much, but never too shallow.
#include <gtest/gtest.h>

#include "parity/convex_pairs.h"

namespace obby::parity {
namespace {

using geom::Separation;
using geom::ShapeKind;

constexpr float kSeparationMargin = 0.5f;
constexpr double kDeeper = double(geom::internal::kPreference) + kTolerance;

// A tally of answers. If corners or edges are closest, an answer is only a lower bound of the
// distance.
struct Found {
  int pairs = 0, overlapping = 0, apart = 0, deeperThanPreferred = 0;
  double deeper = 0, shallower = 0, early = 0;  // studs

  // `exact` is the signed distance. For overlaps it is minus the minimum translation that separates
  // the two.
  void compare(const ConvexPair& p, const Separation& s, double exact, double maxDeeper,
               double maxEarly) {
    ++pairs;
    const double ours = double(s.distance);
    const std::string pair = describe(p.a) + "\n" + describe(p.b);
    ASSERT_TRUE(std::isfinite(ours)) << pair;
    ASSERT_NEAR(double(length(s.normal)), 1, 1e-5) << pair;
    ASSERT_LE(ours, exact + kTolerance) << pair;
    if (exact > double(kSeparationMargin)) return;
    shallower = std::max(shallower, ours - exact);
    ++(exact <= 0 ? overlapping : apart);
    double& worst = exact <= 0 ? deeper : early;
    worst = std::max(worst, exact - ours);
    deeperThanPreferred += exact - ours > kDeeper;
    ASSERT_GE(ours, exact - (exact <= 0 ? maxDeeper : maxEarly)) << pair;
  }
  void report() const {
    testing::Test::RecordProperty("pairs", pairs);
    testing::Test::RecordProperty("overlapping", overlapping);
    testing::Test::RecordProperty("apart", apart);
    testing::Test::RecordProperty("deeper_than_preferred", deeperThanPreferred);
    testing::Test::RecordProperty("deeper", std::to_string(deeper));
    testing::Test::RecordProperty("shallower", std::to_string(shallower));
    testing::Test::RecordProperty("early", std::to_string(early));
  }
};

constexpr ShapeKind kPolytopes[] = {ShapeKind::block, ShapeKind::wedge, ShapeKind::cornerWedge,
                                    ShapeKind::hull};

// Returns the overlap of a and b along a unit vector, in double precision.
double overlapAlong(const Polytope& a, const Polytope& b, const V3& n) {
  double max = -1e300, min = 1e300;
  for (const V3& q : a.points) max = std::max(max, n.dot(q));
  for (const V3& q : b.points) min = std::min(min, n.dot(q));
  return max - min;
}

TEST(SeparationParity, PolytopesMatchTheSearchOfAllAxes) {
  ConvexDice dice(700);
  Found found;
  int normals = 0;
  for (int i = 0; i < 600000 && !HasFatalFailure(); ++i) {
    const ConvexPair p = dice.pair(kPolytopes[i % 4], kPolytopes[i / 4 % 4]);
    const Separation s = geom::separation(p.a, p.b, kSeparationMargin);
    const Polytope a = polytopeOf(p.a, p.localA), b = polytopeOf(p.b, p.localB);
    const Exact exact = exactPenetration(a, b);
    // If edges are parallel, the exact axes give only a lower bound, which can be arbitrarily far
    // from the truth.
    if (exact.depth < 0) continue;
    // The compiler's tables merge nearly parallel edges of a hull.
    found.compare(p, s, -exact.depth, 5e-3, kDeeper);
    const std::string pair = describe(p.a) + "\n" + describe(p.b);
    ASSERT_NEAR(overlapAlong(a, b, wide(s.normal)), double(-s.distance), kTolerance) << pair;
    if (exact.next < exact.depth + 1e-2) continue;
    ++normals;
    ASSERT_GT(wide(s.normal).dot(exact.normal), 0.999 - kNormalTolerance) << pair;
  }
  found.report();
  RecordProperty("normals", normals);
  EXPECT_GT(found.overlapping, 200000);
  EXPECT_GT(normals, 80000);
  EXPECT_LT(found.deeperThanPreferred, found.pairs / 10000);
}

// For separated polytopes the answer is at most Bullet's distance. The answer is rarely far less:
// only between corners, whose direction is not an axis.
TEST(SeparationParity, NeverExceedsTheDistanceOfSeparatedPolytopes) {
  ConvexDice dice(703);
  Found found;
  int referenceWrong = 0, half = 0;
  for (int i = 0; i < 100000 && !HasFatalFailure(); ++i) {
    const ConvexPair p = dice.pair(kPolytopes[i % 4], kPolytopes[i / 4 % 4]);
    const Separation s = geom::separation(p.a, p.b, kSeparationMargin);
    const BulletContact bullet = bulletApart(p.a, p.b);
    if (bullet.overlap || bullet.depth > -kTolerance) continue;
    if (double(s.distance) > -bullet.depth + kTolerance) {
      // The axis of our answer proves that Bullet's distance is wrong.
      const Polytope a = polytopeOf(p.a, p.localA), b = polytopeOf(p.b, p.localB);
      ASSERT_LT(overlapAlong(a, b, wide(s.normal)), bullet.depth) << describe(p.a);
      ++referenceWrong;
      continue;
    }
    found.compare(p, s, -bullet.depth, kDeeper, 0.5);
    half += double(s.distance) < -0.5 * bullet.depth - kDeeper;
  }
  found.report();
  RecordProperty("reference_wrong", referenceWrong);
  RecordProperty("half", half);
  EXPECT_GT(found.apart, 20000);
  EXPECT_LT(half, found.apart / 25);
}

TEST(SeparationParity, ABallAndAPolytopeFollowTheCentre) {
  ConvexDice dice(701);
  Found found;
  for (int i = 0; i < 140000 && !HasFatalFailure(); ++i) {
    ConvexPair p = dice.pair(ShapeKind::ball, kPolytopes[i % 4]);
    const double exact = pointApart(polytopeOf(p.b, p.localB), wide(p.a.pose.position)) -
                         double(geom::Ball::radius(p.a.shape));
    if (i / 4 % 2) std::swap(p.a, p.b);
    // Near shapes of 50 studs the direction to the centre is less precise.
    found.compare(p, geom::separation(p.a, p.b, kSeparationMargin), exact, 4e-3, 1e-2);
  }
  found.report();
  EXPECT_GT(found.overlapping, 60000);
  EXPECT_LT(found.deeperThanPreferred, found.pairs / 500);
}

TEST(SeparationParity, ABallAndARoundShapeFollowTheCentre) {
  ConvexDice dice(702);
  Found found;
  for (int i = 0; i < 80000 && !HasFatalFailure(); ++i) {
    const bool isBall = i % 4 == 0;
    ConvexPair p = dice.pair(ShapeKind::ball, isBall ? ShapeKind::ball : ShapeKind::cylinder);
    const V3 at = wide(p.a.pose.position);
    const double apart =
        isBall ? (at - wide(p.b.pose.position)).norm() - double(geom::Ball::radius(p.b.shape))
               : pointApartOfCylinder(p.b, at);
    const double exact = apart - double(geom::Ball::radius(p.a.shape));
    if (i / 4 % 2) std::swap(p.a, p.b);
    found.compare(p, geom::separation(p.a, p.b, kSeparationMargin), exact, 1e-2, 1e-2);
  }
  found.report();
  EXPECT_GT(found.overlapping, 30000);
  EXPECT_LT(found.deeperThanPreferred, found.pairs / 1000);
}

// If a tilted rim meets an edge, a corner or another rim, the only axes are those of a smaller
// cylinder. Contact then comes up to a tenth of a stud early, and one deep overlap in ten is too
// deep.
TEST(SeparationParity, ACylinderIsTooDeepOnlyAtRims) {
  ConvexDice dice(704);
  Found found;
  int referenceWrong = 0;
  constexpr ShapeKind kOther[] = {ShapeKind::block, ShapeKind::wedge, ShapeKind::cornerWedge,
                                  ShapeKind::hull, ShapeKind::cylinder};
  for (int i = 0; i < 80000 && !HasFatalFailure(); ++i) {
    ConvexPair p = dice.pair(ShapeKind::cylinder, kOther[i % 5]);
    if (i / 5 % 2) std::swap(p.a, p.b);
    const Separation s = geom::separation(p.a, p.b, kSeparationMargin);
    const double bullet = -bulletApart(p.a, p.b).depth;
    if (double(s.distance) > bullet + kTolerance) {
      // EPA or GJK has not converged. After b is moved out by our answer, Bullet also reports no
      // overlap.
      ConvexPair out = p;
      out.b.pose.position += s.normal * (float(kTolerance) - s.distance);
      EXPECT_LE(bulletApart(out.a, out.b).depth, 2 * kTolerance) << describe(p.a);
      ++referenceWrong;
      continue;
    }
    found.compare(p, s, bullet, 4, 0.2);
  }
  found.report();
  RecordProperty("reference_wrong", referenceWrong);
  EXPECT_GT(found.overlapping, 30000);
  EXPECT_LT(found.deeperThanPreferred, found.pairs / 10);
  EXPECT_LT(referenceWrong, found.pairs / 200);
}

}  // namespace
}  // namespace obby::parity
