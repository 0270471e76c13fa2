// Tests contacts of the player's box with blocks, by the general form and the two short ones, in a
// million pairs. The references are Bullet's GJK and EPA and FCL's closed form. If a reference
// differs, the exact separating axes in double precision decide (exact.h).
#include "geom/box_box.h"

#include <gtest/gtest.h>

#include "parity/fcl.h"
#include "parity/pairs.h"

namespace obby::parity {
namespace {

using geom::Contact;
using geom::ShapeKind;

struct Tallies {
  Tally bullet;
  int fclWrong = 0;

  void check(const Pair& p, const Contact& ours, double tolerance = kTolerance) {
    const Exact exact = exactPenetration(polytopeOf(p.kind, p.shape, p.pose), polytopeOf(p.box));
    const BulletContact b = BulletPair(p.kind, p.shape, p.pose).with(p.box);
    bullet.compare(p, ours, b.depth, wide(b.normal), exact, tolerance);
    checkFcl(p, ours, exact, tolerance);
  }

  // Checks overlap against FCL, and depth within FCL's preference for faces.
  void checkFcl(const Pair& p, const Contact& ours, const Exact& exact, double tolerance) {
    const FclContact f = fclBoxBox(p.pose, p.shape.half, p.box);
    const double depth = double(ours.depth);
    const bool touching = std::abs(depth) <= tolerance;
    const bool right = f.overlap ? depth >= -tolerance && f.depth >= depth - tolerance &&
                                       f.depth <= depth * kFclPreference + tolerance
                                 : depth < 0 || touching;
    if (right) return;
    EXPECT_TRUE(agree(depth, exact.depth, tolerance)) << describe(p);
    ++fclWrong;
  }

  void expectGood(int min) const {
    bullet.report();
    testing::Test::RecordProperty("fcl_wrong", fclWrong);
    EXPECT_GT(bullet.overlapping, min);
    EXPECT_GT(bullet.normals, min / 2);
    EXPECT_EQ(fclWrong, 0);
    // For a few pairs in a thousand, EPA fails or stops at a face that is not the best.
    EXPECT_LE(bullet.referenceWrong, bullet.pairs / 200);
  }
};

TEST(BlockParity, UprightBlocksByBothForms) {
  PairDice dice(500);
  Tallies tallies;
  for (int i = 0; i < 400000; ++i) {
    const geom::ShapeData shape{dice.extents(0.025f, 16), nullptr};
    const Pair p = dice.around(ShapeKind::block, shape, i % 3 ? dice.standing() : Mat3{});
    const Contact ours = geom::boxUprightBlock<float>({p.pose, p.shape.half}, p.box);
    const Contact general = geom::penetration(p.kind, p.shape, p.pose, p.box);
    ASSERT_TRUE(agree(double(ours.depth), double(general.depth), kTolerance)) << describe(p);
    tallies.check(p, ours);
    if (HasFailure()) return;
  }
  tallies.expectGood(100000);
}

TEST(BlockParity, BlocksAtAnyRotation) {
  PairDice dice(501);
  Tallies tallies;
  for (int i = 0; i < 400000; ++i) {
    const geom::ShapeData shape{dice.extents(0.025f, 16), nullptr};
    const Pair p = dice.around(ShapeKind::block, shape, dice.rotation());
    tallies.check(p, geom::boxTiltedBlock<float>({p.pose, p.shape.half}, p.box));
    if (HasFailure()) return;
  }
  tallies.expectGood(100000);
}

TEST(BlockParity, BlocksNearlyAlignedWithTheBody) {
  PairDice dice(502);
  Tallies tallies;
  for (int i = 0; i < 100000; ++i) {
    const geom::ShapeData shape{dice.extents(0.025f, 16), nullptr};
    Pair p = dice.around(ShapeKind::block, shape, {});
    p.pose.rotation = dice.nearly(p.box.axes());
    tallies.check(p, geom::penetration(p.kind, p.shape, p.pose, p.box));
    if (HasFailure()) return;
  }
  tallies.expectGood(20000);
}

// The largest parts have half extents of 1024 studs, where floats are 1e-4 apart. The axes of a
// rotation in single precision are orthogonal to within about 1e-6.
TEST(BlockParity, BlocksOfUpTo2048StudsWithinTheirOwnRounding) {
  PairDice dice(503);
  Tallies tallies;
  for (int i = 0; i < 100000; ++i) {
    const geom::ShapeData shape{dice.extents(0.025f, 1024), nullptr};
    const Pair p = dice.around(ShapeKind::block, shape, dice.rotation());
    const double tolerance = kTolerance + 2e-6 * double(length(shape.half));
    tallies.check(p, geom::penetration(p.kind, p.shape, p.pose, p.box), tolerance);
    if (HasFailure()) return;
  }
  tallies.expectGood(20000);
}

}  // namespace
}  // namespace obby::parity
