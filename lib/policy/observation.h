// What the policy sees: the player's state, where it has to go, and the ground around it
// (columns.h) now and a moment later, in a frame that looks toward the next region.
// kObservationVersion changes whenever a number here means something else.
#pragma once

#include "policy/columns.h"
#include "policy/surroundings_view.h"
#include "sim/next_region.h"

namespace obby::policy {

constexpr uint32_t kObservationVersion = 1;

constexpr float kSoon = 0.4f;  // seconds: about when a jump that begins now is at its end
constexpr int kStateInputs = 28;
constexpr int kInputs = kStateInputs + kMaps * kPoints;  // 272

// A level and a query, as the policy sees them.
struct Scene {
  const level::LevelView& level;
  const level::QueryView& query;
  const SurroundingsView& surroundings;
};

// Where the frame looks: toward the centre of the next region; from right above or below it, where
// the player looks.
OBBY_DEVICE Turns aheadOf(const geom::Region& next, const sim::World& w) {
  const float x = next.pose.position.x - w.position.x, z = next.pose.position.z - w.position.z;
  return x * x + z * z < 0.25f ? w.yaw : headingOf(x, z);
}

// Can a jump begin at the next tick, or soon after landing?
OBBY_DEVICE bool mayJump(const level::LevelView& level, const sim::World& w) {
  if (w.state == sim::State::climbing || w.state == sim::State::seated) return true;
  return (w.state == sim::State::running || w.state == sim::State::landed) &&
         w.floorlessTicks < level.params.coyoteTicks;
}

// A map's heights in [-2, 1.25].
OBBY_DEVICE float scaledHeight(float studs) { return studs * 0.125f; }

OBBY_DEVICE float squashed(float v, float half) { return v / (absf(v) + half); }

// Times are told in ticks of 1/60 s, whatever the level's are: a tick of its in those.
OBBY_DEVICE float ticksOfSixty(const level::LevelView& level) {
  return 60.0f / float(level.params.controlRate);
}

// The state's part of the observation: kStateInputs numbers of order 1.
OBBY_DEVICE void observeState(const Scene& s, const sim::World& w, const sim::NextRegion& next,
                              Turns ahead, float* out) {
  const SinCos frame = sinCos(ahead);
  const Vec3 forward = directionOf(frame), right{-forward.z, 0, forward.x};
  const Params p = w.clockCount == 0 ? s.level.params : sim::boosted(w, s.level);
  const Vec3 to = next.region->pose.position - w.position;
  const float flat = sqrtf32(to.x * to.x + to.z * to.z);
  const float tick = ticksOfSixty(s.level);
  const auto in = [&](sim::State state) { return w.state == state ? 1.0f : 0.0f; };
  int i = 0;
  out[i++] = dot(w.velocity, forward) * 0.0625f;
  out[i++] = dot(w.velocity, right) * 0.0625f;
  out[i++] = clampf(w.velocity.y * 0.02f, -3.0f, 3.0f);
  out[i++] = w.floorlessTicks == 0 ? 1.0f : 0.0f;
  out[i++] = minf(float(w.floorlessTicks) * tick, 30.0f) * 0.0333f;
  out[i++] = in(sim::State::running) + in(sim::State::landed);
  out[i++] = in(sim::State::landed);
  out[i++] = in(sim::State::jumping);
  out[i++] = in(sim::State::freefall);
  out[i++] = in(sim::State::climbing);
  out[i++] = in(sim::State::seated) + in(sim::State::fallingDown);
  out[i++] = mayJump(s.level, w) ? 1.0f : 0.0f;
  out[i++] = squashed(flat, 16.0f);
  out[i++] = minf(flat, 16.0f) * 0.0625f;
  out[i++] = squashed(to.y, 8.0f);
  out[i++] = clampf(to.y * 0.125f, -2.0f, 2.0f);
  out[i++] = minf(next.region->half.x + next.region->half.z, 16.0f) * 0.0625f;
  out[i++] = minf(next.region->half.y, 8.0f) * 0.125f;
  const SinCos facing = sinCos(Turns(w.yaw - ahead));
  out[i++] = facing.sin;
  out[i++] = facing.cos;
  const uint32_t jumps = sim::jumpsLeft(s.query, w);
  out[i++] = float(jumps < 4 ? jumps : 4) * 0.25f;
  const uint32_t limit = s.query.timeLimitTicks;
  const float left =
      limit == 0 ? 600.0f : (float(limit) - float(sim::ticksPlayed(w, s.query))) * tick;
  out[i++] = squashed(maxf(left, 0.0f), 240.0f);
  out[i++] = w.health / p.maxHealth;
  out[i++] = p.walkSpeed * 0.0625f;
  const float reach = 2 * p.jumpSpeed * p.walkSpeed / maxf(p.gravity, 1.0f);
  out[i++] = minf(reach, 30.0f) * 0.1f;
  out[i++] = minf(0.5f * p.jumpSpeed * p.jumpSpeed / maxf(p.gravity, 1.0f), 30.0f) * 0.125f;
  out[i++] = w.waypoints < s.query.waypointCount ? 1.0f : 0.0f;
  out[i++] = 1.0f;
}

// A collider as a column cuts it, in the pose that it has `later` ticks after the world.
OBBY_DEVICE Solid solidOf(const level::Collider& c, const Pose& pose, Vec3 feet) {
  return {pose.position - feet, pose.rotation, c.shape.half, c.kind == geom::ShapeKind::wedge};
}

// What map a collider belongs to.
OBBY_DEVICE bool isDanger(uint32_t flags) { return (flags & level::kKill) != 0; }

OBBY_DEVICE bool inSight(const Box& box, Vec3 feet) {
  return box.lo.x < feet.x + kSight && box.hi.x > feet.x - kSight && box.lo.z < feet.z + kSight &&
         box.hi.z > feet.z - kSight && box.lo.y < feet.y + kHeadroom &&
         box.hi.y > feet.y + kDeepest;
}

// Calls see(solid, danger, now, soon) for everything that can stand or lie in view; a part that
// changes is seen twice, as it is now and as it will be.
template <class See>
OBBY_DEVICE void lookAround(const Scene& s, const sim::World& w, const sim::LooseBody* loose,
                            See&& see) {
  const SurroundingsView& around = s.surroundings;
  const float cx = (w.position.x - around.origin.x) * around.inverseCell;
  const float cz = (w.position.z - around.origin.z) * around.inverseCell;
  sim::World later = w;
  const uint32_t soonTicks = ticksFromSeconds(s.level.params, kSoon);
  later.tick += soonTicks;
  for (int i = 0; i < later.clockCount; ++i) later.clocks[i].ticks += soonTicks;
  if (cx >= 0 && cz >= 0 && cx < float(around.nx) && cz < float(around.nz)) {
    const uint32_t cell = uint32_t(cz) * uint32_t(around.nx) + uint32_t(cx);
    for (uint32_t e = around.starts[cell]; e < around.starts[cell + 1]; ++e) {
      const uint32_t id = around.entries[e];
      const level::Bounds& b = s.level.bounds[id];
      if (!inSight(b.box(), w.position)) continue;
      const level::Collider& c = s.level.colliders[id];
      const bool danger = isDanger(b.flags);
      if (b.flags & (level::kMoving | sim::kLeaves)) {
        const Pose now = sim::poseAfter(s.level, w, loose, c);
        const Pose soon = sim::poseAfter(s.level, later, loose, c);
        see(solidOf(c, now, w.position), danger, !sim::hasLeft(w, s.level, c, b.flags), false);
        see(solidOf(c, soon, w.position), danger, false, !sim::hasLeft(later, s.level, c, b.flags));
      } else {
        see(solidOf(c, c.pose, w.position), danger, true, true);
      }
    }
  }
  for (uint32_t i = 0; i < s.level.looseCount; ++i) {
    const level::Loose& l = s.level.loose[i];
    if (loose[i].state == sim::LooseState::gone) continue;
    const Pose pose = sim::poseOf(loose[i], l);
    for (uint32_t id = l.firstCollider; id < l.firstCollider + l.colliderCount; ++id) {
      const level::Collider& c = s.level.colliders[id];
      if (!inSight(boundsOf(pose, c.shape.half), w.position)) continue;
      see(solidOf(c, pose, w.position), isDanger(s.level.bounds[id].flags), true, true);
    }
  }
  for (uint32_t i = 0; i < s.query.avoidCount; ++i) {
    const geom::Region& r = s.query.avoid[i].region;
    if (!inSight(boundsOf(r.pose, r.half), w.position)) continue;
    see(Solid{r.pose.position - w.position, r.pose.rotation, r.half, false}, true, true, true);
  }
}

// Fills `inputs` (kInputs) with what the policy sees of a player who is to reach `next`, in a frame
// that looks `ahead`. `loose`: (level.looseCount).
template <class F>
OBBY_DEVICE void observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
                         const sim::NextRegion& next, Turns ahead, float* inputs) {
  observeState(scene, world, next, ahead, inputs);
  Rosette rosette;
  placePoints(ahead, rosette);
  Maps<F> maps;
  lookAround(scene, world, loose, [&](const Solid& solid, bool danger, bool now, bool soon) {
    maps.see(rosette, solid, danger, now, soon);
  });
  float* out = inputs + kStateInputs;
  for (const auto& map : maps.heights) {
    for (int i = 0; i < kPoints; ++i) *out++ = scaledHeight(map[i]);
  }
}

// Parts of an observation that can be filled in by themselves: the points, then the state.
constexpr int kViewParts = kPoints + 1;

// One part of it. All together have the bits of observe(): for devices that have a thread for each.
OBBY_DEVICE void observePart(const Scene& scene, const sim::World& world,
                             const sim::LooseBody* loose, const sim::NextRegion& next, Turns ahead,
                             int part, float* inputs) {
  if (part == kPoints) {
    observeState(scene, world, next, ahead, inputs);
    return;
  }
  PointMaps maps(ahead, part);
  lookAround(scene, world, loose, [&](const Solid& solid, bool danger, bool now, bool soon) {
    maps.see(solid, danger, now, soon);
  });
  float* const out = inputs + kStateInputs + part;
  for (int map = 0; map < kMaps; ++map) out[map * kPoints] = scaledHeight(maps.heights[map]);
}

// Fills `inputs` with what is seen of the query's next region, looking toward it; gives that
// direction.
template <class F>
OBBY_DEVICE Turns observe(const Scene& scene, const sim::World& world, const sim::LooseBody* loose,
                          float* inputs) {
  const sim::NextRegion next = nextRegion(scene.query, world);
  const Turns ahead = aheadOf(*next.region, world);
  observe<F>(scene, world, loose, next, ahead, inputs);
  return ahead;
}

}  // namespace obby::policy
