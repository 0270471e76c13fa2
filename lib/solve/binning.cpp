#include "solve/binning.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr float kUsualSpeed = 16;      // studs/s
constexpr float kClockSeconds = 0.5f;  // a bin of the clock
constexpr uint32_t kHealthBins = 4;

bool anyCollider(const level::LevelView& level, auto&& test) {
  for (uint32_t i = 0; i < level.colliderCount; ++i) {
    if (test(i)) return true;
  }
  return false;
}

// Parts that hurt without killing at once: then health matters.
bool hurts(const level::LevelView& level) {
  return anyCollider(level, [&](uint32_t i) {
    return (level.bounds[i].flags & level::kKill) &&
           level.roles[level.colliders[i].role].damage < level.params.maxHealth;
  });
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
  b.jumps = limitsJumps(problem.query);
  b.waypoints = problem.query.waypointCount > 0;
  b.looseCount = problem.level.looseCount;
  b.clocks = anyCollider(problem.level, [&](uint32_t i) {
    return (problem.level.bounds[i].flags & (level::kStarts | level::kSeat)) != 0;
  });
  return b;
}

}  // namespace obby::solve
