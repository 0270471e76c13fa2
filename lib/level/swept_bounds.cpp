#include "level/swept_bounds.h"

namespace obby::level {
namespace {

bool same(const Mat3& a, const Mat3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

}  // namespace

SweptBounds::SweptBounds(const Mover& m) : spins_(m.spinCount != 0), pivotAway_(length(m.pivot)) {
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Pose& key = m.keys[k];
    const Vec3 at = spins_ ? toWorld(key, m.pivot) : key.position;
    if (!runs_.empty() && (spins_ || same(runs_.back().rotation, key.rotation))) {
      runs_.back().places = join(runs_.back().places, {at, at});
    } else {
      runs_.push_back({key.rotation, {at, at}});
    }
  }
}

// Adding the same extent to all rows keeps their order, rounding included: the outermost places
// give the outermost bounds, to the bit.
Box SweptBounds::of(Vec3 half) const {
  const float radius = length(half) + pivotAway_;
  Box swept{{1e30f, 1e30f, 1e30f}, {-1e30f, -1e30f, -1e30f}};
  for (const Run& run : runs_) {
    const Vec3 extent =
        spins_ ? Vec3{radius, radius, radius} : boundsOf(Pose{{}, run.rotation}, half).hi;
    swept = join(swept, {run.places.lo - extent, run.places.hi + extent});
  }
  return swept;
}

}  // namespace obby::level
