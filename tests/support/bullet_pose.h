// Vectors and poses as Bullet's types, for either precision of its build.
#pragma once

#include <btBulletCollisionCommon.h>

#include "math/vec.h"

namespace obby::test {

inline btVector3 bulletVector(Vec3 v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }

inline btTransform bulletTransform(const Mat3& r, Vec3 at) {
  // Bullet's matrix takes rows, and ours holds columns.
  const btMatrix3x3 basis(btScalar(r.x.x), btScalar(r.y.x), btScalar(r.z.x), btScalar(r.x.y),
                          btScalar(r.y.y), btScalar(r.z.y), btScalar(r.x.z), btScalar(r.y.z),
                          btScalar(r.z.z));
  return btTransform(basis, bulletVector(at));
}

}  // namespace obby::test
