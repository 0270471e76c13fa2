// Finds every solid in sight of a player, now and shortly after.
#pragma once

#include "policy/columns.h"
#include "policy/surroundings_view.h"
#include "sim/next_region.h"

namespace obby::policy {

// A level and a query, as the policy sees them.
struct Scene {
  const level::LevelView& level;
  const level::QueryView& query;
  const SurroundingsView& surroundings;
};

OBBY_DEVICE Kind kindOf(uint32_t flags) { return flags & level::kKill ? kDanger : kFloor; }

// Returns a collider in this pose as a solid.
OBBY_DEVICE Solid solidOf(const level::Collider& c, const Pose& pose, Vec3 feet) {
  return {pose.position - feet, pose.rotation, c.shape, c.kind};
}

// Returns true if a player at `feet` passes under the box.
OBBY_DEVICE bool isOverhead(const Box& box, Vec3 feet) { return box.lo.y >= feet.y + kHeadroom; }

OBBY_DEVICE bool inSight(const Box& box, Vec3 feet) {
  return box.hi.y > feet.y + kDeepest && !isOverhead(box, feet) && box.lo.x < feet.x + kSight &&
         box.hi.x > feet.x - kSight && box.lo.z < feet.z + kSight && box.hi.z > feet.z - kSight;
}

// The state of the world at each moment, as far as parts depend on it.
struct Foresight {
  const sim::World& now;
  sim::World later[kMoments - 1];

  OBBY_DEVICE Foresight(const Params& params, const sim::World& w) : now(w) {
    for (int m = 1; m < kMoments; ++m) {
      const uint32_t ticks = ticksFromSeconds(params, kSoon * float(m));
      sim::World& then = later[m - 1];
      then = w;
      then.tick += ticks;
      for (int i = 0; i < w.clockCount; ++i) then.clocks[i].ticks += ticks;
    }
  }
  OBBY_DEVICE const sim::World& at(int moment) const {
    return moment == 0 ? now : later[moment - 1];
  }
};

// Calls see(sight) for every solid in view. A part that changes is reported once for each moment.
template <class See>
OBBY_DEVICE void lookAround(const Scene& s, const sim::World& w, const sim::RigidBody* bodies,
                            See&& see) {
  const SurroundingsView& around = s.surroundings;
  const float cx = (w.position.x - around.origin.x) * around.inverseCell;
  const float cz = (w.position.z - around.origin.z) * around.inverseCell;
  const Foresight foresight(s.level.params, w);
  if (cx >= 0 && cz >= 0 && cx < float(around.nx) && cz < float(around.nz)) {
    const uint32_t cell = uint32_t(cz) * uint32_t(around.nx) + uint32_t(cx);
    for (uint32_t e = around.starts[cell]; e < around.starts[cell + 1]; ++e) {
      const uint32_t id = around.entries[e];
      const level::Bounds& b = s.level.bounds[id];
      if (isOverhead(b.box(), w.position)) break;  // all later entries begin even higher
      if (!inSight(b.box(), w.position)) continue;
      const level::Collider& c = s.level.colliders[id];
      const Kind kind = kindOf(b.flags);
      if (!(b.flags & (level::kMoving | sim::kLeaves))) {
        see({solidOf(c, c.pose, w.position), kind, kAlways, id});
        continue;
      }
      for (int m = 0; m < kMoments; ++m) {
        const sim::World& then = foresight.at(m);
        if (sim::hasLeft(then, s.level, c, b.flags)) continue;
        const Pose pose = sim::poseAfter(s.level, then, bodies, c);
        see({solidOf(c, pose, w.position), kind, Moments(1) << m, id});
      }
    }
  }
  for (uint32_t i = 0; i < s.level.bodyCount; ++i) {
    const level::DynamicBody& l = s.level.bodies[i];
    if (bodies[i].state == sim::RigidBodyState::gone) continue;
    const Pose pose = sim::poseOf(bodies[i], l);
    for (uint32_t id = l.firstCollider; id < l.firstCollider + l.colliderCount; ++id) {
      const level::Collider& c = s.level.colliders[id];
      if (!inSight(boundsOf(pose, c.shape.half), w.position)) continue;
      const Kind kind = kindOf(s.level.bounds[id].flags);
      see({solidOf(c, pose, w.position), kind, kAlways, id});
    }
  }
  for (uint32_t i = 0; i < s.query.avoidCount; ++i) {
    const geom::Region& r = s.query.avoid[i].region;
    if (!inSight(boundsOf(r.pose, r.half), w.position)) continue;
    see({{r.pose.position - w.position, r.pose.rotation, {r.half}}, kDanger, kAlways});
  }
}

}  // namespace obby::policy
