// Random pairs of a shape and the player's box. About half of the pairs overlap. Also a tally that
// compares answers of lib/geom with those of an outside library.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geom/penetration.h"
#include "parity/bullet.h"
#include "parity/exact.h"

namespace obby::parity {

constexpr double kTolerance = 1e-4;        // studs
constexpr double kNormalTolerance = 1e-5;  // 1 - cosine: a quarter of a degree

struct Pair {
  geom::ShapeKind kind;
  geom::ShapeData shape;
  Pose pose;
  geom::UprightBox box;
};

class PairDice : public geom::test::Dice {
 public:
  using Dice::Dice;

  // Returns random extents. Thin, medium and wide ones are equally likely.
  Vec3 extents(float min, float max) {
    const auto one = [&] { return min * std::pow(max / min, between(0, 1)); };
    return {one(), one(), one()};
  }
  // Returns half extents of the body, of the head alone, or of any box.
  Vec3 bodyHalf() {
    switch (random().below(4)) {
      case 0: return {1, 0.5f, 0.5f};
      case 1: return {between(0.2f, 2), between(0.2f, 2), between(0.2f, 2)};
      default: return {1, 1.5f, 0.5f};
    }
  }
  Mat3 standing() { return geom::UprightBox{{}, {}, sinCos(turns())}.axes(); }
  // Returns the rotation with an error of 1e-7 to 0.1 radians, so that edges are nearly parallel.
  Mat3 nearly(const Mat3& base) {
    const double angle = std::pow(10.0, double(between(-7, -1)));
    const Eigen::AngleAxisd turn(angle, wide(direction()).normalized());
    const auto turned = [&](Vec3 v) {
      const V3 w = turn * wide(v);
      return Vec3{float(w.x()), float(w.y()), float(w.z())};
    };
    return {turned(base.x), turned(base.y), turned(base.z)};
  }
  // Returns a box near the shape's bounding box.
  Pair around(geom::ShapeKind kind, const geom::ShapeData& shape, const Mat3& rotation) {
    const Pose pose{vec(8), rotation};
    const Vec3 half = bodyHalf();
    const Vec3 on = toWorld(pose, mul(shape.half, vec(1)));
    return {kind, shape, pose, {on + vec(1.2f), half, sinCos(turns())}};
  }
};

inline std::string describe(const Pair& p) {
  const auto v = [](Vec3 a) {
    return "{" + std::to_string(a.x) + ", " + std::to_string(a.y) + ", " + std::to_string(a.z) +
           "}";
  };
  return "kind " + std::to_string(int(p.kind)) + " half " + v(p.shape.half) + " at " +
         v(p.pose.position) + " x " + v(p.pose.rotation.x) + " z " + v(p.pose.rotation.z) +
         " box half " + v(p.box.half) + " at " + v(p.box.center) + " sin " +
         std::to_string(p.box.yaw.sin);
}

// Returns true if both are negative (apart), or if the depths agree within the tolerance.
inline bool agree(double a, double b, double tolerance) {
  return (a < 0 && b < 0) || std::abs(a - b) <= tolerance;
}

struct Tally {
  int pairs = 0, overlapping = 0, normals = 0, referenceWrong = 0;
  double worst = 0;           // largest difference from references that are right
  double referenceWorst = 0;  // the reference's largest error against the exact depth

  // Every pair must agree with the exact answer. If the reference contradicts the exact answer, it
  // counts as wrong and is not compared.
  void compare(const Pair& pair, const geom::Contact& ours, double referenceDepth,
               const V3& referenceNormal, const Exact& exact, double tolerance = kTolerance) {
    ++pairs;
    const double depth = double(ours.depth);
    overlapping += exact.depth >= 0;
    if (!agree(depth, exact.depth, tolerance)) {
      ADD_FAILURE() << "ours " << depth << ", exact " << exact.depth << ", reference "
                    << referenceDepth << ": " << describe(pair);
      return;
    }
    if (!agree(depth, referenceDepth, tolerance)) {
      ++referenceWrong;
      if (exact.depth >= 0) {
        referenceWorst = std::max(referenceWorst, std::abs(referenceDepth - exact.depth));
      }
      return;
    }
    if (depth < 0 || referenceDepth < 0) return;
    worst = std::max(worst, std::abs(depth - referenceDepth));
    if (exact.next < exact.depth + 1e-2 || exact.depth < 1e-3)
      return;  // the minimum axis is not unique
    ++normals;
    const V3 normal = wide(ours.normal);
    EXPECT_GT(normal.dot(exact.normal), 1 - kNormalTolerance) << describe(pair);
    referenceWrong += normal.dot(referenceNormal) <= 1 - kNormalTolerance;
  }

  void report() const {
    testing::Test::RecordProperty("pairs", pairs);
    testing::Test::RecordProperty("overlapping", overlapping);
    testing::Test::RecordProperty("normals", normals);
    testing::Test::RecordProperty("worst", std::to_string(worst));
    testing::Test::RecordProperty("reference_wrong", referenceWrong);
    testing::Test::RecordProperty("reference_worst", std::to_string(referenceWorst));
  }
};

}  // namespace obby::parity
