// Writes the small values of the schema that several records share.
#pragma once

#include "import/document/pose_math.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::importer {

inline void setVector(schema::Vec3::Builder to, Vec3 from) {
  to.setX(from.x + 0.0f);  // avoids negative zero, which would print as -0
  to.setY(from.y + 0.0f);
  to.setZ(from.z + 0.0f);
}

inline void setRotation(schema::Quat::Builder to, const Mat3& from) {
  const Quat q = toQuat(from);
  to.setX(q.x);
  to.setY(q.y);
  to.setZ(q.z);
  to.setW(q.w);
}

}  // namespace obby::importer
