#include "policy/surroundings.h"

#include <algorithm>
#include <cmath>

namespace obby::policy {

namespace {

constexpr float kLeastCell = 8;      // studs
constexpr float kMostCells = 256;    // each way: huge levels get wider cells
constexpr float kFarthest = 1.0e5f;  // studs: what is farther out is nobody's ground

bool isSeen(uint32_t flags) {
  return (flags & (level::kSolid | level::kKill)) != 0 && (flags & level::kLoose) == 0;
}

Box within(const Box& box) {
  const Vec3 far{kFarthest, kFarthest, kFarthest};
  return {max(min(box.lo, far), -far), max(min(box.hi, far), -far)};
}

}  // namespace

Surroundings::Surroundings(const level::LevelView& level, float reach) {
  Box all{};
  bool any = false;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (!isSeen(level.bounds[i].flags)) continue;
    const Box box = within(level.bounds[i].box());
    all = any ? Box{min(all.lo, box.lo), max(all.hi, box.hi)} : box;
    any = true;
  }
  starts_ = {0};
  if (!any) return;
  origin_ = all.lo - Vec3{reach, 0, reach};
  const Vec3 extent = all.hi + Vec3{reach, 0, reach} - origin_;
  cell_ = std::max(kLeastCell, std::max(extent.x, extent.z) / kMostCells);
  nx_ = int32_t(extent.x / cell_) + 1;
  nz_ = int32_t(extent.z / cell_) + 1;
  starts_.assign(size_t(nx_) * size_t(nz_) + 1, 0);
  const auto forSquares = [&](auto&& visit) {
    for (uint32_t i = 0; i < level.colliderCount; ++i) {
      if (!isSeen(level.bounds[i].flags)) continue;
      const Square s = squareOf(level.bounds[i].box(), reach);
      for (int32_t z = s.z0; z <= s.z1; ++z) {
        for (int32_t x = s.x0; x <= s.x1; ++x) visit(size_t(z) * size_t(nx_) + size_t(x), i);
      }
    }
  };
  forSquares([&](size_t cell, uint32_t) { ++starts_[cell + 1]; });
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  entries_.resize(starts_.back());
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  forSquares([&](size_t cell, uint32_t i) { entries_[next[cell]++] = i; });
}

Surroundings::Square Surroundings::squareOf(const Box& box, float reach) const {
  const Box b = within(box);
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
