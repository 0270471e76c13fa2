#include "solve/search/archive/binning.h"

#include <algorithm>

#include "solve/model/targets.h"

namespace obby::solve {

namespace {

constexpr float kUsualSpeed = 16;      // studs/s
constexpr float kClockSeconds = 0.5f;  // width of a bin of the clock
constexpr uint32_t kHealthBins = 4;

bool anyCollider(const level::LevelView& level, auto&& test) {
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (test(i)) return true;
  }
  return false;
}

// Returns true if a part hurts without killing at once, so that health matters.
bool hurts(const level::LevelView& level) {
  return anyCollider(level, [&](uint32_t i) {
    return (level.bounds[i].flags & level::kKill) &&
           level.roles[level.colliders[i].role].damage < level.params.maxHealth;
  });
}

constexpr uint32_t kSegmentBins = 8;  // bins per shortest time limit of a segment
constexpr float kDamageBins = 8;      // bins of the health that the player may lose

// Returns the shortest time limit of a segment, in ticks; 0 if there is none.
uint32_t minSegment(const level::QueryView& q) {
  uint32_t min = q.last.ticks;
  for (uint32_t i = 0; i < q.waypointCount; ++i) {
    const uint32_t ticks = q.waypoints[i].segment.ticks;
    if (ticks != 0 && (min == 0 || ticks < min)) min = ticks;
  }
  return min;
}

void binProgress(Binning& b, const level::QueryView& q) {
  b.jumps = limitsTotalJumps(q) || q.minJumps > 0;
  if (!limitsTotalJumps(q)) b.maxJumps = uint32_t(q.minJumps);
  b.visits = q.visitCount > 0;
  b.segmentJumps = limitsSegmentJumps(q);
  if (limitsSegmentTime(q)) b.segmentBin = std::max(1u, minSegment(q) / kSegmentBins);
  if (q.maxDamage > 0) b.inverseDamage = kDamageBins / q.maxDamage;
}

}  // namespace

Binning makeBinning(const Problem& problem, float width, const ClockMap& clock) {
  const Params& p = problem.level.params;
  Binning b;
  const float scale = std::clamp(p.walkSpeed / kUsualSpeed, 1.0f, 2.0f);
  b.inverseWidth = 1 / (width * scale);
  b.inverseHeight = 1 / (2 * width * scale);
  b.clock = clock.view();
  if (problem.hasClock) b.clockBin = std::max(1u, uint32_t(kClockSeconds * float(p.controlRate)));
  if (hurts(problem.level)) b.healthBins = kHealthBins;
  b.inverseHealth = 1 / std::max(p.maxHealth, 1.0f);
  binProgress(b, problem.query);
  b.waypoints = problem.query.waypointCount > 0;
  b.bodyCount = problem.level.bodyCount;
  b.clocks = anyCollider(problem.level, [&](uint32_t i) {
    return (problem.level.bounds[i].flags & (level::kStarts | level::kSeat)) != 0;
  });
  return b;
}

}  // namespace obby::solve
