// A surface-aimed macro: pick a place to stand within a jump or so, walk straight to it, jump when
// the support ends, at some distance before, or not at all, and steer in the air.
#pragma once

#include "base/random.h"
#include "solve/explore_context.h"

namespace obby::solve {

struct AimMacro {
  SurfacePoint target;
  Vec3 error;          // studs off the target, so that repeated aims differ
  float jumpDistance;  // jump at this distance to the target; negative: not for distance
  bool jumpAtEdge;     // jump once no floor is sensed any more (within the coyote time)
  bool jumped;
  Turns heading;   // held until it is off by kHeadingSlack, so that actions come in runs
  uint32_t ticks;  // left before giving up
};

constexpr int kHeadingSlack = 512;  // turns / 65536: 2.8 degrees

OBBY_DEVICE float within(Random& random, float most) { return most * (2 * random.unit() - 1); }

// Draws when to jump, and some error of aim. `rise`: studs from the feet up to the target.
OBBY_DEVICE void drawAimDetails(const ExploreContext& c, Random& random, float rise, AimMacro& m) {
  m.error = {within(random, 0.7f), 0, within(random, 0.7f)};
  const float u = random.unit();
  m.jumpAtEdge = u < 0.6f;
  m.jumpDistance = -1;
  if ((u >= 0.3f && u < 0.9f) || (rise > 1.5f && u >= 0.3f)) {
    m.jumpDistance = 1 + random.unit() * c.reach.distance;
  }
  m.jumped = false;
  m.heading = Turns(random.next());
  m.ticks = uint32_t(c.reach.airTicks) + 4 + random.below(32);
}

// A point inside the next region, at its foot.
OBBY_DEVICE Vec3 pointInRegion(const geom::Region& region, Random& random) {
  const Vec3 local{within(random, 0.8f * region.half.x), -region.half.y,
                   within(random, 0.8f * region.half.z)};
  return toWorld(region.pose, local);
}

// False: nothing near to aim at.
OBBY_DEVICE bool drawAimMacro(const ExploreContext& c, const sim::World& w, Random& random,
                              AimMacro& m) {
  const float radius = 1.4f * c.reach.distance;
  const geom::Region& region = targetRegion(c.query, w.waypoints);
  const bool regionNear = geom::distance(region, w.position) < 2 * radius;
  if (regionNear && random.unit() < c.settings.regionShare) {
    m.target = {pointInRegion(region, random), level::kNone};
    drawAimDetails(c, random, m.target.position.y - w.position.y, m);
    return true;
  }
  const float highest = c.reach.height + 0.5f, deepest = 30;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const uint32_t i = pickPoint(c.surfaces, w.position, radius, deepest, highest, random);
    if (i == level::kNone) return false;
    m.target = c.surfaces.points[i];
    const Vec3 to = positionAt(c.level, m.target, w.tick) - w.position;
    const float flat2 = to.x * to.x + to.z * to.z;
    if (to.y > highest || to.y < -deepest || flat2 > radius * radius || flat2 < 1) continue;
    drawAimDetails(c, random, to.y, m);
    return true;
  }
  return false;
}

// The action of this tick; `done` when the macro has served.
OBBY_DEVICE sim::Action stepAimMacro(const ExploreContext& c, const sim::World& w, AimMacro& m,
                                     bool& done) {
  const Vec3 to = positionAt(c.level, m.target, w.tick) + m.error - w.position;
  const float flat = sqrtf32(to.x * to.x + to.z * to.z);
  const float speed2 = w.velocity.x * w.velocity.x + w.velocity.z * w.velocity.z;
  const float brake = 0.5f * speed2 / maxf(c.level.params.airAccel, 1.0f);
  const bool onGround = grounded(w);
  sim::Action action;
  const Turns wanted = headingOf(to.x, to.z);
  const int off = int16_t(Turns(wanted - m.heading));
  if (off > kHeadingSlack || off < -kHeadingSlack) m.heading = wanted;
  action.walk = flat > (onGround ? 0.3f : brake);
  if (action.walk) action.heading = m.heading;
  const bool edge = m.jumpAtEdge && w.state == sim::State::running && w.floorlessTicks > 0;
  const bool early = onGround && flat <= m.jumpDistance;
  action.jump = !m.jumped && (edge || early);
  if (w.state == sim::State::jumping) m.jumped = true;
  m.ticks = m.ticks > 0 ? m.ticks - 1 : 0;
  done = m.ticks == 0 || (onGround && flat < 0.7f);
  return action;
}

}  // namespace obby::solve
