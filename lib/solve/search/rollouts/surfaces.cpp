#include "solve/search/rollouts/surfaces.h"

#include <algorithm>
#include <cmath>

#include "geom/shapes/table.h"

namespace obby::solve {

namespace {

constexpr float kSpacing = 3;       // studs between the points of one part
constexpr int kMaxPerSide = 48;     // points per part and axis; larger parts get a wider spacing
constexpr float kClimbSpacing = 6;  // studs between the points along a truss: below a jump's height
constexpr float kWaist = 2.5f;      // studs above the feet
constexpr size_t kMaxSurfaceCells = 1u << 20;
constexpr size_t kMaxEntriesPerPoint = 256;  // per moving point; longer tracks are thinned out

int sampleCount(float extent) {
  return std::clamp(int(std::lround(extent / kSpacing)), 1, kMaxPerSide);
}

Pose poseAtStart(const level::LevelView& level, const level::Collider& c) {
  return c.mover == level::kNone ? c.pose : moverPose(level.movers[c.mover], 0);
}

// Finds the first point of the collider below `top`. Returns true if a player can stand there.
bool standingPoint(const level::Collider& c, const Pose& pose, Vec3 top, float depth,
                   float minNormalY, Vec3& point) {
  const Vec3 origin = toLocal(pose, top), direction = toLocal(pose.rotation, Vec3{0, -1, 0});
  geom::RayHit hit{};
  const bool met = geom::visitShape(
      c.kind, [&](auto shape) { return shape.castRay(c.shape, origin, direction, depth, hit); });
  if (!met || (pose.rotation * hit.normal).y < minNormalY) return false;
  point = top - Vec3{0, hit.t, 0};
  return true;
}

// Returns true for a part without collision that is worth going to.
bool isTouchTarget(uint32_t flags) {
  return (flags & (level::kStarts | level::kTeleport | level::kSeat)) != 0 &&
         (flags & (level::kSolid | level::kKill)) == 0;
}

}  // namespace

Surfaces::Surfaces(const level::LevelView& level) {
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if ((level.bounds[i].flags & level::kSolid) && !(level.bounds[i].flags & level::kKill))
      samplePart(level, i);
    if (isTouchTarget(level.bounds[i].flags)) addTouchTarget(level, i);
  }
  buildGrid();
}

void Surfaces::samplePart(const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  const Pose pose = poseAtStart(level, c);
  const Box box = boundsOf(pose, c.shape.half);
  const Vec3 extent = box.hi - box.lo;
  const int nx = sampleCount(extent.x), nz = sampleCount(extent.z);
  const float minNormalY = std::max(level.params.slopeNormalY, 0.3f);
  for (int ix = 0; ix < nx; ++ix) {
    for (int iz = 0; iz < nz; ++iz) {
      const Vec3 top{box.lo.x + extent.x * (float(ix) + 0.5f) / float(nx), box.hi.y + 0.1f,
                     box.lo.z + extent.z * (float(iz) + 0.5f) / float(nz)};
      Vec3 point;
      if (!standingPoint(c, pose, top, extent.y + 0.2f, minNormalY, point)) continue;
      addPoint(level, collider, pose, point);
    }
  }
  if (!(level.bounds[collider].flags & level::kTruss)) return;
  for (float y = box.lo.y; y < box.hi.y; y += kClimbSpacing) {
    addPoint(level, collider, pose, {pose.position.x, y, pose.position.z});
  }
}

void Surfaces::addTouchTarget(const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  const Pose pose = poseAtStart(level, c);
  const Box box = boundsOf(pose, c.shape.half);
  const Vec3 center = pose.position;
  addPoint(level, collider, pose, {center.x, std::max(box.lo.y, center.y - kWaist), center.z});
}

void Surfaces::addPoint(const level::LevelView& level, uint32_t collider, const Pose& pose,
                        Vec3 point) {
  const uint32_t mover = level.colliders[collider].mover;
  const bool moves = mover != level::kNone;
  points_.push_back({moves ? toLocal(pose, point) : point, mover});
  reach_.push_back(moves ? level.bounds[collider].box() : Box{point, point});
}

void Surfaces::buildGrid() {
  if (points_.empty()) {
    starts_ = {0, 0};
    return;
  }
  Box all = reach_.front();
  for (const Box& b : reach_) all = join(all, b);
  origin_ = all.lo;
  const Vec3 extent = all.hi - all.lo;
  const auto count = [](float length, float cell) {
    return int32_t(std::clamp(length / cell, 0.0f, 1e6f)) + 1;
  };
  while (double(count(extent.x, width_)) * count(extent.y, height_) * count(extent.z, width_) >
         double(kMaxSurfaceCells)) {
    width_ *= 2;
    height_ *= 2;
  }
  nx_ = count(extent.x, width_);
  ny_ = count(extent.y, height_);
  nz_ = count(extent.z, width_);

  const auto forCells = [&](const Box& b, auto&& visit) {
    const auto at = [](float v, float o, float cell, int32_t n) {
      return std::clamp(int32_t((v - o) / cell), 0, n - 1);
    };
    const int32_t x0 = at(b.lo.x, origin_.x, width_, nx_), x1 = at(b.hi.x, origin_.x, width_, nx_);
    const int32_t y0 = at(b.lo.y, origin_.y, height_, ny_),
                  y1 = at(b.hi.y, origin_.y, height_, ny_);
    const int32_t z0 = at(b.lo.z, origin_.z, width_, nz_), z1 = at(b.hi.z, origin_.z, width_, nz_);
    const size_t cells = size_t(x1 - x0 + 1) * size_t(y1 - y0 + 1) * size_t(z1 - z0 + 1);
    const size_t step = cells / kMaxEntriesPerPoint + 1;
    size_t i = 0;
    for (int32_t y = y0; y <= y1; ++y) {
      for (int32_t z = z0; z <= z1; ++z) {
        for (int32_t x = x0; x <= x1; ++x) {
          if (i++ % step == 0) visit((size_t(y) * nz_ + z) * nx_ + x);
        }
      }
    }
  };
  starts_.assign(size_t(nx_) * ny_ * nz_ + 1, 0);
  for (const Box& b : reach_) forCells(b, [&](size_t cell) { ++starts_[cell + 1]; });
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_.back());
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (uint32_t p = 0; p < points_.size(); ++p) {
    forCells(reach_[p], [&](size_t cell) { entries_[next[cell]++] = p; });
  }
}

SurfaceView Surfaces::view() const {
  return {points_.data(),
          entries_.data(),
          starts_.data(),
          origin_,
          1 / width_,
          1 / height_,
          nx_,
          ny_,
          nz_,
          uint32_t(points_.size())};
}

}  // namespace obby::solve
