#include "solve/search/archive/clock_map.h"

#include <algorithm>
#include <numeric>

namespace obby::solve {

namespace {

constexpr uint64_t kLongestPeriod = 3600;  // ticks; longer periods use the clock's value itself
constexpr double kMaxClockCells = double(1 << 20);
constexpr double kMaxMarks = 2e7;  // cells written in total, which bounds the time to build

// Returns the ticks after which the collider's state repeats; 0: it never does; kNoClock: it never
// changes.
uint32_t periodOf(const level::LevelView& level, uint32_t collider) {
  const level::Collider& c = level.colliders[collider];
  uint32_t period = kNoClock;
  if (c.mover != level::kNone) {
    const level::Mover& m = level.movers[c.mover];
    if (m.trigger == level::kNone)
      period = m.once ? 0 : jointPeriod(m.keyCount, std::max(m.spinCount, 1u));
  }
  if (level.bounds[collider].flags & level::kVanishTimer) {
    const level::Roles& r = level.roles[c.role];
    period = jointPeriod(period, r.vanishDelay + r.vanishAway);
  }
  return period;
}

// Ticks per bin of a running clock: an eighth of its length, but at least half a second.
constexpr uint32_t kMinBin = 30;
uint32_t binOf(uint32_t length) { return std::max(kMinBin, length / 8); }

int32_t cellsAlong(float length, float cell) { return int32_t(std::min(length / cell, 1e5f)) + 1; }

double cellsOf(const Box& b, float cell) {
  const Vec3 e = b.hi - b.lo;
  return double(cellsAlong(e.x, cell)) * cellsAlong(e.y, cell) * cellsAlong(e.z, cell);
}

}  // namespace

uint32_t jointPeriod(uint32_t a, uint32_t b) {
  if (a == kNoClock || b == kNoClock) return a == kNoClock ? b : a;
  if (a == 0 || b == 0) return 0;
  const uint64_t joint = uint64_t(a) / std::gcd(a, b) * b;
  return joint <= kLongestPeriod ? uint32_t(joint) : 0;
}

ClockMap::ClockMap(const level::LevelView& level, float reach) {
  findBins(level);
  std::vector<Clocked> parts;
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const uint32_t period = periodOf(level, i);
    if (period != kNoClock)
      parts.push_back({grow(level.bounds[i].box(), {reach, reach, reach}), period});
  }
  if (parts.empty()) return;
  layOut(parts);
  for (const Clocked& part : parts) mark(part);
}

void ClockMap::layOut(const std::vector<Clocked>& parts) {
  Box all = parts.front().box;
  for (const Clocked& part : parts) all = join(all, part.box);
  const auto marks = [&] {
    double sum = 0;
    for (const Clocked& part : parts) sum += cellsOf(part.box, cell_);
    return sum;
  };
  while ((cellsOf(all, cell_) > kMaxClockCells || marks() > kMaxMarks) && cell_ < 1e5f) cell_ *= 2;
  origin_ = all.lo;
  const Vec3 extent = all.hi - all.lo;
  nx_ = cellsAlong(extent.x, cell_);
  ny_ = cellsAlong(extent.y, cell_);
  nz_ = cellsAlong(extent.z, cell_);
  periods_.assign(size_t(nx_) * size_t(ny_) * size_t(nz_), kNoClock);
}

void ClockMap::mark(const Clocked& part) {
  const auto at = [&](float v, float origin, int32_t n) {
    return std::clamp(int32_t((v - origin) / cell_), 0, n - 1);
  };
  const Box& b = part.box;
  const int32_t x0 = at(b.lo.x, origin_.x, nx_), x1 = at(b.hi.x, origin_.x, nx_);
  const int32_t z0 = at(b.lo.z, origin_.z, nz_), z1 = at(b.hi.z, origin_.z, nz_);
  const int32_t y0 = at(b.lo.y, origin_.y, ny_), y1 = at(b.hi.y, origin_.y, ny_);
  for (int32_t y = y0; y <= y1; ++y) {
    for (int32_t z = z0; z <= z1; ++z) {
      uint32_t* row = periods_.data() + (size_t(y) * size_t(nz_) + size_t(z)) * size_t(nx_);
      for (int32_t x = x0; x <= x1; ++x) row[x] = jointPeriod(row[x], part.period);
    }
  }
}

// Signals, boosts and motions that touches start decide where a player can go. A level may have
// many parts that vanish or fall when touched, so their clocks are only counted (cell.h).
void ClockMap::findBins(const level::LevelView& level) {
  bins_.assign(level.clockCount, 0);
  const auto count = [&](uint32_t clock) {
    const uint32_t length = level.clocks[clock].length;
    if (length > 1) bins_[clock] = length == level::kForever ? kMinBin : binOf(length);
  };
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    const level::Collider& c = level.colliders[i];
    if ((level.bounds[i].flags & (level::kStarts | level::kTriggered)) == 0) continue;
    const level::Roles& r = level.roles[c.role];
    for (const uint32_t clock : r.starts) {
      if (clock != level::kNone && clock != c.role) count(clock);
    }
    if (c.mover == level::kNone || level.movers[c.mover].trigger == level::kNone) continue;
    if (level.movers[c.mover].trigger != r.awayClock) count(level.movers[c.mover].trigger);
  }
}

ClockView ClockMap::view() const {
  return {periods_.data(), origin_, 1 / cell_, nx_, ny_, nz_, bins_.data(), uint32_t(bins_.size())};
}

}  // namespace obby::solve
