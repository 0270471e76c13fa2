// Bullet's answers (double-precision build): penetration by GJK and EPA without margins, gaps by
// GJK, and rays by its convex cast.
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <btBulletCollisionCommon.h>

#include <memory>

#include "geom/random_shapes.h"
#include "support/bullet_pose.h"

namespace obby::parity {

using test::bulletTransform;
using test::bulletVector;

// Returns Bullet's version of the shape. Its margin is 0, or the radius for a ball.
inline std::unique_ptr<btConvexShape> bulletShape(geom::ShapeKind kind,
                                                  const geom::ShapeData& shape) {
  using geom::ShapeKind;
  const Vec3 h = shape.half;
  if (kind == ShapeKind::ball) {
    return std::make_unique<btSphereShape>(btScalar(minf(h.x, minf(h.y, h.z))));
  }
  std::unique_ptr<btConvexShape> made;
  if (kind == ShapeKind::block || kind == ShapeKind::truss) {
    made = std::make_unique<btBoxShape>(bulletVector(h));
  } else if (kind == ShapeKind::cylinder) {
    const float r = minf(h.y, h.z);
    made = std::make_unique<btCylinderShapeX>(bulletVector({h.x, r, r}));
  } else {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3 c : geom::test::corners(kind, shape)) {
      hull->addPoint(bulletVector(c), false);
    }
    hull->recalcLocalAabb();
    made = std::move(hull);
  }
  made->setMargin(0);
  return made;
}

struct BulletContact {
  bool overlap = false;
  double depth = 0;  // studs; negative distance if apart
  Vec3 normal;       // moving the box along the normal separates the two; zero if apart
};

class BulletPair {
 public:
  BulletPair(geom::ShapeKind kind, const geom::ShapeData& shape, const Pose& pose)
      : shape_(bulletShape(kind, shape)), pose_(bulletTransform(pose.rotation, pose.position)) {}

  BulletContact with(const geom::UprightBox& box) const {
    btBoxShape other(bulletVector(box.half));
    other.setMargin(0);
    const btTransform at = bulletTransform(box.axes(), box.center);
    btGjkEpaSolver2::sResults results;
    const btVector3 guess = at.getOrigin() - pose_.getOrigin();
    if (btGjkEpaSolver2::Penetration(shape_.get(), pose_, &other, at, guess, results)) {
      return {true, -double(results.distance),
              narrow(pose_.getBasis() * -results.normal)};  // local to the shape
    }
    const bool apart = btGjkEpaSolver2::Distance(shape_.get(), pose_, &other, at, guess, results);
    return {
        false, apart ? -double(results.distance) : 0.0, {}};  // touching if Bullet reports neither
  }

 private:
  static Vec3 narrow(const btVector3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }
  std::unique_ptr<btConvexShape> shape_;
  btTransform pose_;
};

}  // namespace obby::parity
