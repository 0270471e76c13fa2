// The parts near a player during one tick, from one grid look-up: their present poses, bounds and
// flags (a vanished part is not solid). The rest of the tick tests only these.
#pragma once

#include "sim/one_way.h"
#include "sim/rigid_body.h"

namespace obby::sim {

constexpr int kMaxCandidates = 48;
constexpr int kMaxMovingCandidates = 16;

struct Candidate {
  Box bounds;
  const Pose* pose;
  uint32_t collider;
  uint32_t flags;
};

struct Candidates {
  // Unions leave the arrays uninitialised, because zeroing them in every tick is slow.
  union {
    Candidate items[kMaxCandidates];  // the first `count` are valid
  };
  union {
    Pose moving[kMaxMovingCandidates];
  };
  union {
    Pose bodies[level::kMaxBodies];  // poses of the bodies, valid for those near the player
  };
  int count = 0;
  int movingCount = 0;
  uint32_t anyFlags = 0;
  uint32_t bodiesNear = 0;   // bodies among the items, one bit each
  int footedOn = -1;         // item on which the feet stand; -1 for none
  uint32_t bodiesApart = 0;  // bodies that wide_bodies.h moves in this tick, one bit each

  OBBY_DEVICE Candidates() {}
};

// Returns the pose of a collider: `later` ticks after the state `w` if a mover moves it, now if it
// is part of a dynamic body. `bodies` is null if the level has no bodies.
OBBY_DEVICE Pose poseOf(const level::Collider& c, const World& w, const RigidBody* bodies,
                        const level::LevelView& level, uint32_t later) {
  if (bodies && c.body != level::kNoBody) return poseOf(bodies[c.body], level.bodies[c.body]);
  return c.mover == level::kNone ? c.pose : poseOf(level.movers[c.mover], w, later);
}

// Returns true if the collider's body has fallen out of the world.
OBBY_DEVICE bool isGone(const level::Collider& c, const RigidBody* bodies) {
  return bodies && c.body != level::kNoBody && bodies[c.body].state == RigidBodyState::gone;
}

// Returns the grid cell that holds `feet`, or -1 outside the grid, where nothing is near.
template <class F>
OBBY_DEVICE IntOf<F> cellOf(const level::Grid& g, Vec3T<F> feet) {
  const Vec3T<F> origin{g.origin.x, g.origin.y, g.origin.z};
  const Vec3T<F> inverse{g.inverseCell.x, g.inverseCell.y, g.inverseCell.z};
  const Vec3T<F> c = mul(feet - origin, inverse);
  const MaskOf<F> within = (c.x >= 0.0f) & (c.y >= 0.0f) & (c.z >= 0.0f) & (c.x < float(g.nx)) &
                           (c.y < float(g.ny)) & (c.z < float(g.nz));
  const Vec3T<F> in = select(within, c, Vec3T<F>{});
  const IntOf<F> cell = (toInt(in.z) * g.ny + toInt(in.y)) * g.nx + toInt(in.x);
  return select(within, cell, IntOf<F>(-1));
}

// Returns the box in which the player's limbs and rays can be during this tick.
template <class F>
OBBY_DEVICE BoxT<F> tickBounds(Vec3T<F> position, Vec3T<F> velocity, const Params& p) {
  const float limbs =
      p.armSpan * 0.5f + p.bodyDepth * 0.5f + p.touchMargin;  // an upper bound of the diagonal
  const float arms = maxf(limbs, p.climbReach + p.bodyWidth * p.floorRaySpread);
  // Half a stud beyond the present speed covers a tick of acceleration, and pushes.
  const F side = arms + 0.5f + p.tickSeconds * maxf(absf(velocity.x), absf(velocity.z));
  const F move = 0.5f + p.tickSeconds * absf(velocity.y) + p.tickSeconds * p.jumpSpeed;
  const float below = p.floorReachBase * p.rootHeight + (farthestFloor(p) - 1.0f) * p.hipHeight;
  return {position - Vec3T<F>{side, below + move, side},
          position + Vec3T<F>{side, p.bodyTop + move, side}};
}

// Flags of parts that may be away (isAway()).
constexpr uint32_t kLeaves = level::kVanishTimer | level::kClocked;

// Flags of parts that can change from tick to tick.
constexpr uint32_t kChanging = level::kMoving | kLeaves | level::kOneWay;

// Returns true if a part is away now.
OBBY_DEVICE bool hasLeft(const World& w, const level::LevelView& level, const level::Collider& c,
                         uint32_t flags) {
  return (flags & kLeaves) && isAway(w, level, c.role, flags);
}

// Returns true if a solid part does not collide with this player now.
OBBY_DEVICE bool lacksCollision(const World& w, const level::LevelView& level,
                                const level::Collider& c, const Pose& pose, uint32_t flags) {
  if (hasLeft(w, level, c, flags)) return true;
  return (flags & level::kOneWay) && !isOutside(w, level, c, pose);
}

// Adds the dynamic bodies near the player.
OBBY_DEVICE void gatherBodies(World& w, const RigidBody* bodies, const level::LevelView& level,
                              const Box& near, Candidates& out) {
  for (uint32_t b = 0; b < level.bodyCount; ++b) {
    const level::DynamicBody& l = level.bodies[b];
    if (!isNear(bodies[b], l, near)) continue;
    out.bodies[b] = poseOf(bodies[b], l);
    for (uint32_t id = l.firstCollider; id < l.firstCollider + l.colliderCount; ++id) {
      const Box bounds = boundsOf(out.bodies[b], level.colliders[id].shape.half);
      if (!overlaps(bounds, near)) continue;
      if (out.count == kMaxCandidates) {
        w.flags |= kCandidateOverrun;
        return;
      }
      const uint32_t flags = level.bounds[id].flags;
      out.items[out.count++] = {bounds, &out.bodies[b], id, flags};
      out.anyFlags |= flags;
      out.bodiesNear |= 1u << b;
    }
  }
}

// Collects the parts near the player. `p` includes the player's boosts.
OBBY_DEVICE void gather(World& w, const RigidBody* bodies, const level::LevelView& level,
                        const Params& p, Candidates& out) {
  const Box near = tickBounds<float>(w.position, w.velocity, p);
  if (level.bodyCount != 0) gatherBodies(w, bodies, level, near, out);
  const int32_t cell = cellOf<float>(level.grid, w.position);
  if (cell < 0) return;
  const uint32_t* list = level.grid.lists + level.grid.cells[cell];
  const uint32_t count = list[0];
  for (uint32_t i = 1; i <= count; ++i) {
    const uint32_t id = list[i];
    Box bounds = level.bounds[id].box();
    if (!overlaps(bounds, near)) continue;
    uint32_t flags = level.bounds[id].flags;
    const level::Collider& c = level.colliders[id];
    const Pose* pose = &c.pose;
    if (flags & kChanging) {
      if ((flags & level::kMoving) && out.movingCount < kMaxMovingCandidates) {
        // Parts move before the player, so this is the pose at the end of the tick.
        out.moving[out.movingCount] = poseOf(level.movers[c.mover], w, 1);
        bounds = boundsOf(out.moving[out.movingCount], c.shape.half);
        if (!overlaps(bounds, near)) continue;
        pose = &out.moving[out.movingCount++];
      } else if (flags & level::kMoving) {
        w.flags |= kCandidateOverrun;
        continue;
      }
      if (lacksCollision(w, level, c, *pose, flags)) flags &= ~uint32_t(level::kSolid);
    }
    if (out.count == kMaxCandidates) {
      w.flags |= kCandidateOverrun;
      return;
    }
    out.items[out.count++] = {bounds, pose, id, flags};
    out.anyFlags |= flags;
  }
}

}  // namespace obby::sim
