// FCL's closed forms (no iteration): two boxes, and a ball and a box.
#pragma once

#include <fcl/narrowphase/detail/primitive_shape_algorithm/box_box-inl.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_box-inl.h>

#include <vector>

#include "parity/exact.h"

namespace obby::parity {

inline fcl::Transform3d fclTransform(const Mat3& r, Vec3 at) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear().col(0) = wide(r.x);
  t.linear().col(1) = wide(r.y);
  t.linear().col(2) = wide(r.z);
  t.translation() = wide(at);
  return t;
}

struct FclContact {
  bool overlap = false;
  double depth = 0;  // studs
  V3 normal = V3::Zero();
};

// FCL prefers faces: it takes an axis between edges only if that axis is better by 5 %. So its
// depth is at most 5 % above the minimum.
constexpr double kFclPreference = 1.05;

inline FclContact fclBoxBox(const Pose& pose, Vec3 half, const geom::UprightBox& box) {
  FclContact out;
  int code = 0;
  std::vector<fcl::ContactPointd> contacts;
  const V3 a = 2 * wide(half), b = 2 * wide(box.half);
  fcl::detail::boxBox2<double>(a, fclTransform(pose.rotation, pose.position), b,
                               fclTransform(box.axes(), box.center), out.normal, &out.depth, &code,
                               1, contacts);
  out.overlap = code != 0;
  return out;
}

inline FclContact fclBallBox(float radius, Vec3 center, const geom::UprightBox& box) {
  const fcl::Sphered ball{double(radius)};
  const fcl::Boxd other{V3(2 * wide(box.half))};
  std::vector<fcl::ContactPointd> contacts;
  if (!fcl::detail::sphereBoxIntersect<double>(ball, fclTransform({}, center), other,
                                               fclTransform(box.axes(), box.center), &contacts)) {
    return {};
  }
  return {true, contacts[0].penetration_depth, contacts[0].normal};
}

}  // namespace obby::parity
