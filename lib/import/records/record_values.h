// Writes the small values of the schema that several records share.
#pragma once

#include "import/document/pose_math.h"
#include "level/record_values.h"

namespace obby::importer {

inline void setVector(schema::Vec3::Builder to, Vec3 from) {
  level::set(to, from + Vec3{});  // without negative zero, which would print as -0
}

inline void setRotation(schema::Quat::Builder to, const Mat3& from) {
  level::set(to, toQuat(from));
}

}  // namespace obby::importer
