#include "policy/surroundings.h"

#include <algorithm>
#include <cmath>

namespace obby::policy {

namespace {

constexpr float kMinCell = 8;              // studs
constexpr float kMaxCells = 256;           // per axis; huge levels get wider cells
constexpr float kFarthest = 1.0e5f;        // studs; parts farther out are never under a player
constexpr uint64_t kMaxEntries = 1 << 24;  // in all cells, 64 MiB; with more, cells get wider
constexpr float kBorder = 0.05f;  // studs; extra reach once cells got wider, against rounding

Box within(const Box& box) {
  const Vec3 far{kFarthest, kFarthest, kFarthest};
  return {max(min(box.lo, far), -far), max(min(box.hi, far), -far)};
}

// Calls visit(collider, bounds) for all visible colliders that are not dynamic.
template <class Visit>
void forSeen(const level::LevelView& level, Visit&& visit) {
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const uint32_t flags = level.bounds[i].flags;
    if ((flags & (level::kSolid | level::kKill)) == 0 || (flags & level::kDynamic) != 0) continue;
    visit(i, within(level.bounds[i].box()));
  }
}

// Returns these colliders, sorted by the bottom of their bounds.
std::vector<uint32_t> lowestFirst(const level::LevelView& level) {
  std::vector<uint32_t> seen;
  forSeen(level, [&](uint32_t i, const Box&) { seen.push_back(i); });
  std::stable_sort(seen.begin(), seen.end(), [&](uint32_t a, uint32_t b) {
    return level.bounds[a].box().lo.y < level.bounds[b].box().lo.y;
  });
  return seen;
}

}  // namespace

Surroundings::Surroundings(const level::LevelView& level, float reach) : starts_{0} {
  Box all{};
  bool any = false;
  forSeen(level, [&](uint32_t, const Box& box) {
    all = any ? join(all, box) : box;
    any = true;
  });
  if (!any) return;
  origin_ = all.lo - Vec3{reach, 0, reach};
  const Vec3 extent = all.hi + Vec3{reach, 0, reach} - origin_;
  divide(extent, std::max(kMinCell, std::max(extent.x, extent.z) / kMaxCells));
  float listed = reach;
  while (entriesOf(level, listed) > kMaxEntries && (nx_ > 1 || nz_ > 1)) {
    divide(extent, 1.5f * cell_);
    listed = reach + kBorder;
  }
  fill(level, listed);
}

void Surroundings::divide(Vec3 extent, float cell) {
  cell_ = cell;
  nx_ = int32_t(extent.x / cell_) + 1;
  nz_ = int32_t(extent.z / cell_) + 1;
}

// The result needs 64 bits: 66 thousand parts of the max size have more entries than 32 bits can
// count.
uint64_t Surroundings::entriesOf(const level::LevelView& level, float reach) const {
  uint64_t entries = 0;
  forSeen(level, [&](uint32_t, const Box& box) {
    const Square s = squareOf(box, reach);
    entries += uint64_t(s.x1 - s.x0 + 1) * uint64_t(s.z1 - s.z0 + 1);
  });
  return entries;
}

void Surroundings::fill(const level::LevelView& level, float reach) {
  const std::vector<uint32_t> seen = lowestFirst(level);
  const auto forCells = [&](auto&& visit) {
    for (const uint32_t i : seen) {
      const Square s = squareOf(within(level.bounds[i].box()), reach);
      for (int32_t z = s.z0; z <= s.z1; ++z) {
        for (int32_t x = s.x0; x <= s.x1; ++x) visit(size_t(z) * size_t(nx_) + size_t(x), i);
      }
    }
  };
  starts_.assign(size_t(nx_) * size_t(nz_) + 1, 0);
  forCells([&](size_t cell, uint32_t) { ++starts_[cell + 1]; });
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_.back());
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  forCells([&](size_t cell, uint32_t i) { entries_[next[cell]++] = i; });
}

Surroundings::Square Surroundings::squareOf(const Box& b, float reach) const {
  const auto cell = [&](float v, float origin, int32_t n) {
    return std::clamp(int32_t(std::floor((v - origin) / cell_)), 0, n - 1);
  };
  return {cell(b.lo.x - reach, origin_.x, nx_), cell(b.hi.x + reach, origin_.x, nx_),
          cell(b.lo.z - reach, origin_.z, nz_), cell(b.hi.z + reach, origin_.z, nz_)};
}

SurroundingsView Surroundings::view() const {
  return {origin_, 1 / cell_, nx_, nz_, starts_.data(), entries_.data(), uint32_t(entries_.size())};
}

}  // namespace obby::policy
