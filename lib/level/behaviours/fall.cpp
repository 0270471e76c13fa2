// Drops the part after a touch, and brings it back.
#include "level/behaviours/fall.h"

#include <algorithm>
#include <cmath>

#include "level/behaviours/behaviour.h"
#include "level/motion_tables.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

struct FallTicks {
  uint32_t delay, fall, away;
};

Result<FallTicks> fallTicks(schema::Fall::Reader fall, const Params& params) {
  FallTicks t{};
  OBBY_ASSIGN(t.delay, ticksOf(params, fall.getDelay(), "fall.delay"));
  OBBY_ASSIGN(t.fall, ticksOf(params, fall.getSeconds(), "fall.seconds"));
  OBBY_ASSIGN(t.away, ticksOf(params, fall.getAway(), "fall.away"));
  if (t.delay + t.fall > maxTicks(params)) {
    return pathError("fall", "'delay' and 'seconds' together are " + longerThanMax(params));
  }
  if (t.fall == 0) return pathError("fall.seconds", "the fall lasts less than one tick");
  return t;
}

}  // namespace

Status compileFall(PartContext& c) {
  const auto record = c.part.getFall();
  if (c.part.hasVanish() || c.part.hasMotion()) {
    return pathError("fall", "a part with 'fall' cannot have 'motion' or 'vanish'",
                     "remove 'fall', or remove 'motion' and 'vanish'");
  }
  if (!(record.getSpeed() >= 0)) {
    return pathError("fall.speed", "expected 0 or more studs/s, found " + shown(record.getSpeed()));
  }
  OBBY_ASSIGN(const FallTicks t, fallTicks(record, c.params));
  if (!c.part.getTouch()) return {};
  OBBY_RETURN_IF_ERROR(startOwn(c, t.delay + t.fall + t.away, "fall"));
  c.roles.awayClock = kOwnClock;
  c.roles.awayFrom = t.delay + (record.getSolid() ? t.fall : 0);
  c.flags |= kClocked;
  return {};
}

std::vector<Pose> fallTable(schema::Fall::Reader fall, const Pose& rest, const Params& params) {
  const uint32_t delay = ticksFromSeconds(params, fall.getDelay());
  const uint32_t rows = delay + ticksFromSeconds(params, fall.getSeconds()) + 1;
  std::vector<Pose> table;
  table.reserve(rows);
  double drop = 0, speed = std::min(double(fall.getSpeed()), double(params.maxFallSpeed));
  const double tick = 1.0 / params.controlRate, gravity = speed > 0 ? 0 : params.gravity;
  for (uint32_t row = 0; row < rows; ++row) {
    if (row > delay) {
      const double next = std::min(speed + gravity * tick, double(params.maxFallSpeed));
      drop += (speed + next) / 2 * tick;
      speed = next;
    }
    Pose pose = rest;
    pose.position.y -= float(drop);
    table.push_back(pose);
  }
  return table;
}

}  // namespace obby::level
