// Makes a player who touches the part faster, slower, lighter or heavier for a time.
#include <cmath>

#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

constexpr float kMaxJumpMore = 1000;  // studs/s

Status checkFactor(float factor, const char* path) {
  if (factor > 0 && factor <= kMaxBoostFactor) return {};
  return pathError(path, "expected a factor above 0 and at most 100, found " + shown(factor),
                   "use 1 to leave the speed unchanged");
}

Status checkGravity(float factor, const Params& params) {
  if (!(factor >= 0 && factor <= kMaxBoostFactor)) {
    return pathError("boost.gravity", "expected a factor from 0 to 100, found " + shown(factor),
                     "use 1 to leave the gravity unchanged");
  }
  if (!(factor * params.gravity <= kMaxGravity)) {
    return pathError("boost.gravity",
                     "expected a factor that gives at most 2000 studs/s^2, found one that gives " +
                         shown(factor * params.gravity),
                     "use a smaller factor");
  }
  return {};
}

}  // namespace

Status compileBoost(PartContext& c) {
  const auto record = c.part.getBoost();
  OBBY_RETURN_IF_ERROR(checkFactor(record.getWalkSpeed(), "boost.walkSpeed"));
  OBBY_RETURN_IF_ERROR(checkFactor(record.getJumpSpeed(), "boost.jumpSpeed"));
  if (!(std::fabs(record.getJumpMore()) <= kMaxJumpMore)) {
    return pathError("boost.jumpMore",
                     "expected -1000 to 1000 studs/s, found " + shown(record.getJumpMore()));
  }
  OBBY_RETURN_IF_ERROR(checkGravity(record.getGravity(), c.params));
  OBBY_ASSIGN(const uint32_t ticks, ticksOf(c.params, record.getSeconds(), "boost.seconds"));
  Clock clock;
  // At least one tick, so that the boost lasts while the part is touched.
  clock.length = record.getForever() ? kForever : ticks + 1;
  clock.restarts = true;
  clock.walkFactor = record.getWalkSpeed();
  clock.jumpFactor = record.getJumpSpeed();
  clock.jumpMore = record.getJumpMore();
  clock.gravityFactor = record.getGravity();
  clock.resets = record.getResets();
  if (!changesWalk(clock) && !changesJump(clock) && !changesGravity(clock)) {
    return pathError("boost", "the boost changes nothing",
                     "set walkSpeed, jumpSpeed, jumpMore or gravity");
  }
  start(c, c.clocks.share(clock));
  return {};
}

}  // namespace obby::level
