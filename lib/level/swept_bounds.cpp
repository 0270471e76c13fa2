#include "level/swept_bounds.h"

#include <algorithm>

namespace obby::level {
namespace {

constexpr size_t kMaxWork = size_t(1) << 24;  // runs of a part times its colliders
constexpr size_t kFewestRuns = 64;

bool same(const Mat3& a, const Mat3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

Mat3 larger(const Mat3& a, const Mat3& b) {
  return {max(abs(a.x), abs(b.x)), max(abs(a.y), abs(b.y)), max(abs(a.z), abs(b.z))};
}

}  // namespace

SweptBounds::SweptBounds(const Mover& m, size_t colliders)
    : spins_(m.spinCount != 0), pivotAway_(length(m.pivot)) {
  for (uint32_t k = 0; k < m.keyCount; ++k) {
    const Pose& key = m.keys[k];
    const Vec3 at = spins_ ? toWorld(key, m.pivot) : key.position;
    if (!runs_.empty() && (spins_ || same(runs_.back().rotation, key.rotation))) {
      runs_.back().places = join(runs_.back().places, {at, at});
    } else {
      runs_.push_back({key.rotation, {at, at}});
    }
  }
  joinRuns(std::max(kFewestRuns, kMaxWork / std::max<size_t>(colliders, 1)));
}

void SweptBounds::joinRuns(size_t limit) {
  if (runs_.size() <= limit) return;
  const size_t together = (runs_.size() + limit - 1) / limit;
  size_t count = 0;
  for (size_t i = 0; i < runs_.size(); ++i) {
    const Run run = runs_[i];
    if (i % together == 0) {
      runs_[count++] = run;
    } else {
      Run& joined = runs_[count - 1];
      joined = {larger(joined.rotation, run.rotation), join(joined.places, run.places)};
    }
  }
  runs_.resize(count);
}

// Adding the same extent to all rows keeps their order, including rounding. The outermost positions
// therefore have exactly the outermost bounds.
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
