// Makes a player who touches it faster, or slower, for a time.
#include <cmath>

#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

// More than this is no boost but a mistake, and would make the grid's lists long.
constexpr float kMostFactor = 100;
constexpr float kMostMore = 1000;  // studs/s

Status checkFactor(float factor, const char* path) {
  if (factor > 0 && factor <= kMostFactor) return {};
  return pathError(path, "expected a factor above 0 and at most 100, found " + shown(factor),
                   "use 1 to leave the speed unchanged");
}

}  // namespace

Status compileBoost(PartContext& c) {
  const auto record = c.part.getBoost();
  OBBY_RETURN_IF_ERROR(checkFactor(record.getWalkSpeed(), "boost.walkSpeed"));
  OBBY_RETURN_IF_ERROR(checkFactor(record.getJumpSpeed(), "boost.jumpSpeed"));
  if (!(std::fabs(record.getJumpMore()) <= kMostMore)) {
    return pathError("boost.jumpMore",
                     "expected -1000 to 1000 studs/s, found " + shown(record.getJumpMore()));
  }
  OBBY_ASSIGN(const uint32_t ticks, ticksOf(c.params, record.getSeconds(), "boost.seconds"));
  Clock clock;
  // One tick at least: it runs on while the part is touched.
  clock.length = record.getForever() ? kForever : ticks + 1;
  clock.restarts = true;
  clock.walkFactor = record.getWalkSpeed();
  clock.jumpFactor = record.getJumpSpeed();
  clock.jumpMore = record.getJumpMore();
  if (!changesWalk(clock) && !changesJump(clock)) {
    return pathError("boost", "the boost changes nothing", "set walkSpeed, jumpSpeed or jumpMore");
  }
  start(c, c.clocks.share(clock));
  return {};
}

}  // namespace obby::level
