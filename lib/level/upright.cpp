#include "level/upright.h"

#include <algorithm>

namespace obby::level {
namespace {

constexpr float kSnap = 1e-6f;

bool isUp(Vec3 axis) { return axis.y > 0 && absf(axis.x) < kSnap && absf(axis.z) < kSnap; }

// Returns the exactly upright rotation with the same facing.
Mat3 snapped(const Mat3& m) {
  const Vec3 x = normalize(Vec3{m.x.x, 0, m.x.z});
  return {x, {0, 1, 0}, {-x.z, 0, x.x}};
}

}  // namespace

bool makeUpright(Collider& c) {
  Mat3& r = c.pose.rotation;
  Vec3& h = c.shape.half;
  if (isUp(r.x) || isUp(-r.x)) {
    r = {r.z, isUp(r.x) ? r.x : -r.x, isUp(r.x) ? r.y : -r.y};
    h = {h.z, h.x, h.y};
  } else if (isUp(r.z) || isUp(-r.z)) {
    r = {isUp(r.z) ? r.y : -r.y, isUp(r.z) ? r.z : -r.z, r.x};
    h = {h.y, h.z, h.x};
    if (dot(cross(r.x, r.y), r.z) < 0) r.z = -r.z;
  } else if (isUp(-r.y)) {
    r = {r.x, -r.y, -r.z};
  } else if (!isUp(r.y)) {
    return false;
  }
  r = snapped(r);
  return true;
}

bool isUpright(const std::vector<Pose>& keys) {
  return std::all_of(keys.begin(), keys.end(),
                     [](const Pose& key) { return isUp(key.rotation.y); });
}

void snapUpright(std::vector<Pose>& keys) {
  for (Pose& key : keys) key.rotation = snapped(key.rotation);
}

bool makeUpright(std::vector<Mat3>& turns) {
  for (const Mat3& turn : turns) {
    if (!isUp(turn.y)) return false;
  }
  for (Mat3& turn : turns) turn = snapped(turn);
  return true;
}

}  // namespace obby::level
