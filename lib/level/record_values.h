// Converts values of the schema to math types, with the checks that every one of them needs.
#pragma once

#include <cmath>
#include <string>

#include "base/result.h"
#include "geom/region.h"
#include "math/vec.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// Positions further out than this lose too much precision to mean anything.
constexpr float kMaxCoordinate = 1e6f;

// Returns an error at a path in the record, such as "parts[88].size".
inline Error pathError(std::string path, std::string message, std::string hint = {}) {
  return Error{{}, {}, std::move(path), std::move(message), std::move(hint)};
}

inline Vec3 vec(schema::Vec3::Reader v) { return {v.getX(), v.getY(), v.getZ()}; }

inline void set(schema::Vec3::Builder to, Vec3 v) {
  to.setX(v.x);
  to.setY(v.y);
  to.setZ(v.z);
}

inline void set(schema::Quat::Builder to, Quat q) {
  to.setX(q.x);
  to.setY(q.y);
  to.setZ(q.z);
  to.setW(q.w);
}

inline bool isFinite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Returns "[1,2.5,3]", the form in which errors show a value.
std::string shown(Vec3 v);
std::string shown(float number);

// This and the next functions return the value, or an error at `path`. Positions are in studs, each
// coordinate within kMaxCoordinate.
inline Result<Vec3> position(schema::Vec3::Reader record, const std::string& path) {
  const Vec3 v = vec(record);
  if (!isFinite(v) || maxf(absf(v.x), maxf(absf(v.y), absf(v.z))) > kMaxCoordinate) {
    return pathError(path, "expected three numbers from -1000000 to 1000000, found " + shown(v));
  }
  return v;
}

// Returns the unit vector along a direction in a part's frame, which may have any length.
inline Result<Vec3> direction(schema::Vec3::Reader record, const std::string& path,
                              const std::string& hint = {}) {
  Vec3 v = vec(record);
  if (maxf(absf(v.x), maxf(absf(v.y), absf(v.z))) > 1e18f) v = v * 1e-20f;  // squares overflow
  if (!isFinite(v) || length(v) < 1e-6f) {
    return pathError(
        path, "expected a nonzero direction in the part's frame, found " + shown(vec(record)),
        hint);
  }
  return normalize(v);
}

// Beyond this many radians float angles are too coarse to mean a direction.
constexpr float kMaxAngle = 1e4f;

// Returns an angle in radians, or an error at `path`.
inline Result<float> angle(float radians, const std::string& path) {
  if (!(absf(radians) <= kMaxAngle))
    return pathError(path, "expected -10000 to 10000 radians, found " + shown(radians));
  return radians;
}

// Returns a unit quaternion. The length in the record must be between 0.001 and 1000.
inline Result<Quat> quaternion(schema::Quat::Reader record, const std::string& path) {
  const Quat q{record.getX(), record.getY(), record.getZ(), record.getW()};
  const float n2 = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(n2 > 1e-6f) || !(n2 < 1e6f))
    return pathError(path, "expected a quaternion [x,y,z,w] whose length is 0.001 to 1000",
                     "use [0,0,0,1] for no rotation");
  return normalize(q);
}

// Returns the same rotation as a matrix.
inline Result<Mat3> rotation(schema::Quat::Reader record, const std::string& path) {
  OBBY_ASSIGN(const Quat q, quaternion(record, path));
  return toMat3(q);
}

// Returns the box, whose sizes must be above 0. Ignores the part that it may name.
inline Result<geom::Region> region(schema::Region::Reader record, const std::string& path) {
  OBBY_ASSIGN(const Vec3 center, position(record.getPosition(), path + ".position"));
  OBBY_ASSIGN(const Mat3 axes, rotation(record.getRotation(), path + ".rotation"));
  const Vec3 size = vec(record.getSize());
  if (!(size.x > 0 && size.y > 0 && size.z > 0) || !isFinite(size)) {
    return pathError(path + ".size", "expected three numbers above 0, found " + shown(size));
  }
  return geom::Region{{center, axes}, size * 0.5f};
}

}  // namespace obby::level
