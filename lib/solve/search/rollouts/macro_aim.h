// A macro aimed at a surface: picks a place to stand within about a jump, walks straight to it, and
// steers in the air. It jumps when the support ends, at some distance before, or not at all.
#pragma once

#include "base/random.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

struct AimMacro {
  // Members that every tick reads come first.
  sim::Action action;  // held until its heading is off by kHeadingSlack, so that actions form runs
  bool jumpAtEdge;     // jump once no floor is sensed (within the coyote time)
  bool jumped;
  float distance;      // studs to the target at the last look
  float jumpDistance;  // jump at this distance to the target; negative: never by distance
  uint32_t ticks;      // ticks left before the macro gives up
  SurfacePoint target;
  Vec3 error;  // studs off the target, so that repeated aims differ
};

constexpr uint32_t kSteerEvery = 3;  // ticks between two looks at the target: 20 Hz
constexpr int kHeadingSlack = 512;   // turns / 65536: 2.8 degrees

OBBY_DEVICE float within(Random& random, float max) { return max * (2 * random.unit() - 1); }

// Draws when to jump, and an aim error. `rise`: studs from the feet up to the target.
OBBY_DEVICE void drawAimDetails(const JumpReach& reach, Random& random, float rise, AimMacro& m) {
  m.error = {within(random, 0.7f), 0, within(random, 0.7f)};
  const float u = random.unit();
  m.jumpAtEdge = u < 0.6f;
  m.jumpDistance = -1;
  if ((u >= 0.3f && u < 0.9f) || (rise > 1.5f && u >= 0.3f)) {
    m.jumpDistance = 1 + random.unit() * reach.distance;
  }
  m.jumped = false;
  m.action = {};
  m.distance = 1e9f;
  m.ticks = (uint32_t(reach.airTicks) / kSteerEvery + 2 + random.below(12)) * kSteerEvery;
}

// Returns a random point inside the region, at its foot.
OBBY_DEVICE Vec3 pointInRegion(const geom::Region& region, Random& random) {
  const Vec3 local{within(random, 0.8f * region.half.x), -region.half.y,
                   within(random, 0.8f * region.half.z)};
  return toWorld(region.pose, local);
}

// Returns false if there is nothing near to aim at.
OBBY_CALLED bool drawAimMacro(const ExploreContext& c, const sim::World& w, Random& random,
                              AimMacro& m) {
  const JumpReach reach = reachIn(c, w);
  const float radius = 1.4f * reach.distance;
  const sim::NextRegion next = nextRegion(c.query, w);
  const bool regionNear = next.distance < 2 * radius;
  if (regionNear && random.unit() < c.settings.regionShare) {
    m.target = {pointInRegion(*next.region, random), level::kNone};
    drawAimDetails(reach, random, m.target.position.y - w.position.y, m);
    return true;
  }
  const float highest = reach.height + 0.5f, deepest = 30;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const uint32_t i = pickPoint(c.surfaces, w.position, radius, deepest, highest, random);
    if (i == level::kNone) return false;
    m.target = c.surfaces.points[i];
    const Vec3 to = positionIn(c.level, m.target, w) - w.position;
    const float flat2 = to.x * to.x + to.z * to.z;
    if (to.y > highest || to.y < -deepest || flat2 > radius * radius || flat2 < 1) continue;
    drawAimDetails(reach, random, to.y, m);
    return true;
  }
  return false;
}

// Turns toward the target. Stops walking once the speed carries the player the rest of the
// distance.
OBBY_CALLED void steer(const ExploreContext& c, const sim::World& w, bool onGround, AimMacro& m) {
  const Vec3 to = positionIn(c.level, m.target, w) + m.error - w.position;
  const float speed2 = w.velocity.x * w.velocity.x + w.velocity.z * w.velocity.z;
  m.distance = sqrtf32(to.x * to.x + to.z * to.z);
  const Turns wanted = headingOf(to.x, to.z);
  const int off = int16_t(Turns(wanted - m.action.heading));
  m.action.walk = onGround ? m.distance > 0.3f : 2 * c.level.params.airAccel * m.distance > speed2;
  if (!m.action.walk) {
    m.action.heading = 0;
  } else if (off > kHeadingSlack || off < -kHeadingSlack) {
    m.action.heading = wanted;
  }
}

// Must be called before the ticks at which a rollout plans. Returns false if the macro is over.
OBBY_DEVICE bool planAimMacro(const ExploreContext& c, const sim::World& w, AimMacro& m) {
  const bool onGround = grounded(w);
  steer(c, w, onGround, m);
  if (m.ticks == 0 || (onGround && m.distance < 0.7f)) return false;
  m.ticks -= kSteerEvery;
  return true;
}

// Returns true if it is time to jump. It has no branches, since the conditions are unpredictable.
OBBY_DEVICE bool jumpsNow(const sim::World& w, AimMacro& m) {
  const bool edge = m.jumpAtEdge & (w.state == sim::State::running) & (w.floorlessSteps > 0);
  const bool early = grounded(w) & (m.distance <= m.jumpDistance);
  m.jumped |= w.state == sim::State::jumping;
  return (edge | early) & !bool(m.jumped);
}

}  // namespace obby::solve
