// Rays at every shape, compared with Bullet's convex cast in double precision by hit or miss,
// distance and side.
#include <gtest/gtest.h>

#include "parity/hull.h"
#include "parity/pairs.h"

namespace obby::parity {
namespace {

using geom::RayHit;
using geom::ShapeData;
using geom::ShapeKind;

struct BulletHit {
  bool hit = false;
  double fraction = 1;
  V3 normal = V3::Zero();
};

// Casts a ray from `from` to `to`, in the shape's frame.
BulletHit castByBullet(btConvexShape* shape, Vec3 from, Vec3 to) {
  struct First : btCollisionWorld::RayResultCallback {
    V3 normal = V3::Zero();
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& r, bool) override {
      m_closestHitFraction = r.m_hitFraction;
      m_collisionObject = r.m_collisionObject;
      normal = {r.m_hitNormalLocal.x(), r.m_hitNormalLocal.y(), r.m_hitNormalLocal.z()};
      return r.m_hitFraction;
    }
  } first;
  btCollisionObject object;
  object.setCollisionShape(shape);
  const auto at = [](Vec3 v) { return btTransform(btMatrix3x3::getIdentity(), bulletVector(v)); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, shape, at({}), first);
  return {first.hasHit(), double(first.m_closestHitFraction), first.normal};
}

// The reference in double precision: the interval of the ray's line that lies inside the shape.
struct Stretch {
  double enter = -1e300, leave = 1e300;

  void clip(const V3& o, const V3& d, const V3& n, double offset) {
    const double speed = n.dot(d), t = (offset - n.dot(o)) / speed;
    if (speed < 0) enter = std::max(enter, t);
    if (speed > 0) leave = std::min(leave, t);
    if (speed == 0 && n.dot(o) > offset) leave = -1e300;
  }
  void clipRound(const V3& o, const V3& d, double r) {
    const double a = d.dot(d), b = o.dot(d), q = b * b - a * (o.dot(o) - r * r);
    if (q < 0) leave = -1e300;
    if (q < 0 || a == 0) return;
    enter = std::max(enter, (-b - std::sqrt(q)) / a);
    leave = std::min(leave, (-b + std::sqrt(q)) / a);
  }
  double chord() const { return leave - enter; }
  bool hit(double length) const { return chord() >= 0 && enter >= 0 && enter <= length; }
};

Stretch exactStretch(ShapeKind kind, const ShapeData& s, const Polytope& polytope, const V3& o,
                     const V3& d) {
  Stretch out;
  const double r = double(s.half.z), x = double(s.half.x);
  if (kind == ShapeKind::ball) {
    out.clipRound(o, d, r);
  } else if (kind == ShapeKind::cylinder) {
    const auto across = [](const V3& v) { return V3(0, v.y(), v.z()); };
    out.clipRound(across(o), across(d), r);
    out.clip(o, d, {1, 0, 0}, x);
    out.clip(o, d, {-1, 0, 0}, x);
  } else {
    for (const V3& face : polytope.faces) {
      for (const V3& n : {face, V3(-face)}) {
        double offset = -1e300;
        for (const V3& p : polytope.points) offset = std::max(offset, n.dot(p));
        out.clip(o, d, n, offset);
      }
    }
  }
  return out;
}

struct Ray {
  Vec3 from, along;  // `along` is a unit vector
  float length;
};

class RayTally {
 public:
  explicit RayTally(ShapeKind kind) : kind_(kind) {}

  void compare(const ShapeData& s, const Polytope& polytope, const Ray& ray) {
    RayHit hit{};
    const bool ours = geom::visitShape(kind_, [&](auto shape) {
      return decltype(shape)::castRay(s, ray.from, ray.along, ray.length, hit);
    });
    const Vec3 to = ray.from + ray.along * ray.length;
    const BulletHit bullet = castByBullet(bulletShape(kind_, s).get(), ray.from, to);
    const double length = (wide(to) - wide(ray.from)).norm();
    const Stretch exact =
        exactStretch(kind_, s, polytope, wide(ray.from), (wide(to) - wide(ray.from)) / length);
    ++rays;
    const double tolerance = kTolerance + rounding(ray, exact);
    if (ours != exact.hit(length)) {
      ++grazing;
      if (exact.chord() > -1e200) worstGraze = std::max(worstGraze, std::abs(exact.chord()));
      EXPECT_TRUE(isGrazing(ray, exact)) << "chord " << exact.chord() << " " << text(s, ray);
      return;
    }
    if (ours) {
      ++hits;
      worst = std::max(worst, std::abs(double(hit.t) - exact.enter));
      EXPECT_NEAR(double(hit.t), exact.enter, tolerance) << text(s, ray);
    }
    const double bullets = bullet.fraction * length;
    if (ours != bullet.hit || (ours && std::abs(bullets - double(hit.t)) > tolerance)) {
      ++referenceWrong;
      return;
    }
    if (!ours) return;
    referenceWorst = std::max(referenceWorst, std::abs(bullets - exact.enter));
    otherSide += wide(hit.normal).dot(bullet.normal) < 0.99;
  }

  void report() const {
    testing::Test::RecordProperty("rays", rays);
    testing::Test::RecordProperty("hits", hits);
    testing::Test::RecordProperty("worst", std::to_string(worst));
    testing::Test::RecordProperty("grazing", grazing);
    testing::Test::RecordProperty("worst_graze", std::to_string(worstGraze));
    testing::Test::RecordProperty("other_side", otherSide);
    testing::Test::RecordProperty("reference_wrong", referenceWrong);
  }

  int rays = 0, hits = 0, grazing = 0, otherSide = 0, referenceWrong = 0;
  double worst = 0, worstGraze = 0, referenceWorst = 0;

 private:
  bool isRound() const { return kind_ == ShapeKind::ball || kind_ == ShapeKind::cylinder; }

  // Returns the rounding of a curved side, which solves a quadratic in single precision. It grows
  // with the squared distance. Hits on small balls from far away, and grazing hits on the side, are
  // less exact.
  double rounding(const Ray& ray, const Stretch& exact) const {
    if (!isRound()) return 0;
    const double far = double(dot(ray.from, ray.from));
    return std::min(0x1p-20 * far / std::max(exact.chord(), 1e-9), 0x1p-10 * std::sqrt(far));
  }
  bool isGrazing(const Ray& ray, const Stretch& exact) const {
    if (exact.chord() < -1e200) return isRound();  // the line misses a curved side
    const double far = double(dot(ray.from, ray.from));
    return std::abs(exact.chord()) < (isRound() ? 0x1p-10 * std::sqrt(far) : kTolerance);
  }
  static std::string text(const ShapeData& s, const Ray& r) {
    const auto v = [](Vec3 a) {
      return "{" + std::to_string(a.x) + ", " + std::to_string(a.y) + ", " + std::to_string(a.z) +
             "} ";
    };
    return "half " + v(s.half) + "from " + v(r.from) + "along " + v(r.along);
  }

  ShapeKind kind_;
};

class RayParity : public testing::TestWithParam<ShapeKind> {
 protected:
  // Returns a random shape. Round shapes have a single radius.
  ShapeData shape() {
    ShapeData s{dice_.extents(0.025f, 16), nullptr};
    if (GetParam() == ShapeKind::ball) s.half = {s.half.z, s.half.z, s.half.z};
    if (GetParam() == ShapeKind::cylinder) s.half.y = s.half.z;
    return s;
  }
  // Returns a ray from up to 20 studs beyond the bounds, towards a point in or just outside the
  // shape.
  Ray rayAt(Vec3 half) {
    const Vec3 from = dice_.direction() * (length(half) + dice_.between(0.01f, 20));
    const Vec3 at = mul(half, dice_.vec(1.1f));
    return {from, normalize(at - from), 2 * length(half) + 42};
  }
  void expectGood(const RayTally& tally) {
    tally.report();
    EXPECT_GT(tally.hits, tally.rays / 5);
    EXPECT_LE(tally.otherSide,
              tally.rays / 200);  // Bullet is inexact at edges and on small balls
    // Bullet's cast counts some rays that pass within 1e-4 studs of an edge as hits.
    EXPECT_LE(tally.referenceWrong, tally.rays / 200);
  }
  PairDice dice_{600 + uint64_t(GetParam())};
};

TEST_P(RayParity, HitsWhereBulletHits) {
  RayTally tally(GetParam());
  for (int i = 0; i < 100000; ++i) {
    const ShapeData s = shape();
    tally.compare(s, polytopeOf(GetParam(), s, {}), rayAt(s.half));
    if (HasFailure()) return;
  }
  expectGood(tally);
}

// Rays like the floor rays of a walking or jumping player. They start within 4 studs and hit well
// inside the silhouette.
class RoundRayParity : public RayParity {};

TEST_P(RoundRayParity, IsExactAtCloseRangeAwayFromTheSilhouette) {
  int hits = 0;
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const ShapeData s = shape();
    const Vec3 along = dice_.direction(), at = mul(s.half, dice_.vec(1));
    const Ray ray{at - along * (3 * s.half.z + dice_.between(0, 4)), along, 100};
    const Stretch exact = exactStretch(GetParam(), s, {}, wide(ray.from), wide(ray.along));
    if (!exact.hit(double(ray.length)) || exact.chord() < double(s.half.z) * 0.5) continue;
    if (GetParam() == ShapeKind::cylinder && absf(ray.along.x) > 0.7f) continue;  // along the axis
    RayHit hit{};
    ASSERT_TRUE(geom::visitShape(GetParam(), [&](auto shape) {
      return decltype(shape)::castRay(s, ray.from, ray.along, ray.length, hit);
    }));
    ++hits;
    worst = std::max(worst, std::abs(double(hit.t) - exact.enter));
  }
  RecordProperty("hits", hits);
  RecordProperty("worst", std::to_string(worst));
  EXPECT_GT(hits, 20000);
  EXPECT_LT(worst, 3e-4);
}

INSTANTIATE_TEST_SUITE_P(Shapes, RoundRayParity,
                         testing::Values(ShapeKind::ball, ShapeKind::cylinder));

INSTANTIATE_TEST_SUITE_P(Shapes, RayParity,
                         testing::Values(ShapeKind::block, ShapeKind::ball, ShapeKind::cylinder,
                                         ShapeKind::wedge, ShapeKind::cornerWedge));

class HullRayParity : public RayParity {};

TEST_P(HullRayParity, HitsWhereBulletHits) {
  RayTally tally(GetParam());
  while (tally.rays < 100000) {
    std::vector<Vec3> points;
    const uint32_t count = 4 + dice_.random().below(12);
    for (uint32_t k = 0; k < count; ++k) points.push_back(dice_.vec(2));
    const TestHull hull(points);
    const ShapeData s{{2, 2, 2}, &hull.hull};
    const Polytope polytope = polytopeOf(GetParam(), s, {});
    if (hull.tables.normals.empty() || hull.hasNearlyEqual(polytope)) continue;
    for (int i = 0; i < 200; ++i) tally.compare(s, polytope, rayAt(s.half));
    if (HasFailure()) return;
  }
  expectGood(tally);
}

INSTANTIATE_TEST_SUITE_P(Shapes, HullRayParity, testing::Values(ShapeKind::hull));

}  // namespace
}  // namespace obby::parity
