// The parts near a player during one tick, from one grid look-up: their poses now, their bounds,
// and what they do now (a vanished part is not solid). Everything later in the tick looks at these
// only.
#pragma once

#include "sim/loose.h"
#include "sim/one_way.h"

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
  // Unions keep the arrays from being zeroed for every tick of every world.
  union {
    Candidate items[kMaxCandidates];  // the first `count` are there
  };
  union {
    Pose moving[kMaxMovingCandidates];
  };
  union {
    Pose loose[level::kMaxLoose];  // by body: where those near the player are
  };
  int count = 0;
  int movingCount = 0;
  uint32_t anyFlags = 0;
  uint32_t looseNear = 0;   // bodies among the items, a bit each
  int footedOn = -1;        // item that the feet hold the player on; -1: none
  uint32_t looseApart = 0;  // bodies that are moved elsewhere in this tick (wide_loose.h)

  OBBY_DEVICE Candidates() {}
};

// Where a collider is, `later` ticks after the state `w` where a mover moves it; where its body is
// now if that is loose. `loose`: null where the level has none.
OBBY_DEVICE Pose poseOf(const level::Collider& c, const World& w, const LooseBody* loose,
                        const level::LevelView& level, uint32_t later) {
  if (loose && c.loose != level::kNotLoose) return poseOf(loose[c.loose], level.loose[c.loose]);
  return c.mover == level::kNone ? c.pose : poseOf(level.movers[c.mover], w, later);
}

// Has it fallen out of the world?
OBBY_DEVICE bool isGone(const level::Collider& c, const LooseBody* loose) {
  return loose && c.loose != level::kNotLoose && loose[c.loose].state == LooseState::gone;
}

// The grid cell that holds `feet`; -1 outside the grid, where nothing is near.
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

// Where the player's limbs and rays can be during this tick.
template <class F>
OBBY_DEVICE BoxT<F> tickBounds(Vec3T<F> position, Vec3T<F> velocity, const Params& p) {
  const float limbs =
      p.armSpan * 0.5f + p.bodyDepth * 0.5f + p.touchMargin;  // at least the diagonal
  const float arms = maxf(limbs, p.climbReach + p.bodyWidth * p.floorRaySpread);
  // Half a stud more than the present speed carries: a tick of acceleration, and being pushed.
  const F side = arms + 0.5f + p.tickSeconds * maxf(absf(velocity.x), absf(velocity.z));
  const F move = 0.5f + p.tickSeconds * absf(velocity.y) + p.tickSeconds * p.jumpSpeed;
  const float below = p.floorReachBase * p.rootHeight + (farthestFloor(p) - 1.0f) * p.hipHeight;
  return {position - Vec3T<F>{side, below + move, side},
          position + Vec3T<F>{side, p.bodyTop + move, side}};
}

// Flags of parts that are away at times, as isAway() tells.
constexpr uint32_t kLeaves = level::kVanishTimer | level::kClocked;

// Flags of parts that are not the same in every tick.
constexpr uint32_t kChanging = level::kMoving | kLeaves | level::kOneWay;

// Is a part away now?
OBBY_DEVICE bool hasLeft(const World& w, const level::LevelView& level, const level::Collider& c,
                         uint32_t flags) {
  return (flags & kLeaves) && isAway(w, level, c.role, flags);
}

// Is a solid part not solid for this player now?
OBBY_DEVICE bool lacksCollision(const World& w, const level::LevelView& level,
                                const level::Collider& c, const Pose& pose, uint32_t flags) {
  if (hasLeft(w, level, c, flags)) return true;
  return (flags & level::kOneWay) && !isOutside(w, level, c, pose);
}

// Loose bodies near the player.
OBBY_DEVICE void gatherLoose(World& w, const LooseBody* loose, const level::LevelView& level,
                             const Box& near, Candidates& out) {
  for (uint32_t b = 0; b < level.looseCount; ++b) {
    const level::Loose& l = level.loose[b];
    if (!isNear(loose[b], l, near)) continue;
    out.loose[b] = poseOf(loose[b], l);
    for (uint32_t id = l.firstCollider; id < l.firstCollider + l.colliderCount; ++id) {
      const Box bounds = boundsOf(out.loose[b], level.colliders[id].shape.half);
      if (!overlaps(bounds, near)) continue;
      if (out.count == kMaxCandidates) {
        w.flags |= kCandidateOverrun;
        return;
      }
      const uint32_t flags = level.bounds[id].flags;
      out.items[out.count++] = {bounds, &out.loose[b], id, flags};
      out.anyFlags |= flags;
      out.looseNear |= 1u << b;
    }
  }
}

// `p`: with the player's boosts.
OBBY_DEVICE void gather(World& w, const LooseBody* loose, const level::LevelView& level,
                        const Params& p, Candidates& out) {
  const Box near = tickBounds<float>(w.position, w.velocity, p);
  if (level.looseCount != 0) gatherLoose(w, loose, level, near, out);
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
        // Parts move first, then the player: the pose at the end of the tick.
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
