// Effects of touches: limbs against parts with a role. The limbs are a fixed pose with the arms at
// the sides: a box as wide as the arms at torso height, and one as wide as the torso from the feet
// to the head.
#pragma once

#include "sim/seat.h"

namespace obby::sim {

struct Limbs {
  geom::UprightBox arms, column;
  geom::UprightBox root;  // the root; only the centre of this box is used
};

OBBY_DEVICE Limbs limbsOf(const World& w, const Params& p) {
  const SinCos yaw = sinCos(w.yaw);
  const float m = p.touchMargin;
  const float armsHalf = (p.headBottom - p.hipHeight) * 0.5f;
  const Vec3 armsCenter = w.position + Vec3{0, p.hipHeight + armsHalf, 0};
  const Vec3 columnCenter = w.position + Vec3{0, p.bodyTop * 0.5f, 0};
  const Vec3 rootCenter = w.position + Vec3{0, p.hipHeight + p.rootHeight * 0.5f, 0};
  return {{armsCenter, Vec3{p.armSpan * 0.5f + m, armsHalf + m, p.bodyDepth * 0.5f + m}, yaw},
          {columnCenter, Vec3{p.bodyWidth * 0.5f + m, p.bodyTop * 0.5f + m, p.bodyDepth * 0.5f + m},
           yaw},
          {rootCenter, Vec3{}, yaw}};
}

OBBY_DEVICE bool touches(const level::Collider& collider, const Candidate& c,
                         const geom::UprightBox& box) {
  return overlaps(box.bounds(), c.bounds) && contactWith(collider, c, box).depth >= 0;
}

// Returns true if a limb touches the part. For parts with kByRoot, tests the centre of the root
// instead.
OBBY_DEVICE bool touches(const level::Collider& collider, const Candidate& c, const Limbs& limbs) {
  const bool byRoot = (c.flags & level::kByRoot) != 0;
  return touches(collider, c, byRoot ? limbs.root : limbs.column) ||
         (!byRoot && touches(collider, c, limbs.arms));
}

OBBY_DEVICE void touchKill(World& w, const level::LevelView& level, const level::Collider& c) {
  const level::Roles& r = level.roles[c.role];
  if (w.hurtTicks > 0 && r.damage < w.health) return;
  w.damage += minf(r.damage, w.health);
  w.health -= r.damage;
  w.hurtTicks = r.cooldownTicks;
  if (w.health > 0) return;
  w.state = State::dead;
  w.outcome = Outcome::killed;
  w.part = c.part;
}

OBBY_DEVICE void touchHeal(World& w, const level::LevelView& level, const level::Roles& r) {
  if (r.healClock != level::kNone) {
    if (findClock(w, r.healClock) >= 0) return;
    startClock(w, level, r.healClock);
  }
  w.health = minf(w.health - r.damage, maxf(w.health, level.params.maxHealth));
}

// Feet touch a floor that holds the player if it is at most this far below them. A landing from a
// jump on flat ground dips 0.28 studs.
constexpr float kFootReach = 0.3f;

// Returns the candidate that the feet touch, or -1 for none.
template <class F>
OBBY_DEVICE IntOf<F> footedOn(MaskOf<F> hover, const FloorT<F>& floor) {
  return select(hover & (floor.gap <= kFootReach), floor.nearest, IntOf<F>(-1));
}

// Puts the player into the air, without a jump left.
OBBY_DEVICE void leaveFloor(World& w) {
  w.state = State::freefall;
  w.floorlessSteps = 0xffff;
  w.flags &= uint8_t(~kFloorSensed);
}

OBBY_DEVICE void touchPad(World& w, const level::LevelView& level, const level::Roles& r) {
  const float speed = length(r.padVelocity);
  if (speed <= 0) return;
  const Vec3 along = r.padVelocity * (1.0f / speed);
  const float now = dot(w.velocity, along);
  if (now > 0.9f * speed) return;  // launched already
  w.velocity =
      bounded(r.padKeepsSideways ? w.velocity + along * (speed - now) : r.padVelocity, level);
  leaveFloor(w);
}

OBBY_DEVICE void teleport(World& w, const level::Roles& r) {
  w.position = r.teleportTo;
  if (r.teleportTurns) w.yaw = r.teleportYaw;
  if (!r.teleportKeepsVelocity) w.velocity = {};
  leaveFloor(w);
  w.flags |= kArrived;
}

// The result of touching one part, for the parts after it.
enum class Touched : uint8_t { stays, inTeleporter, elsewhere };

// A player who was teleported must be clear of all teleporters for a tick before one works again.
// Thus no pair of them can throw a player back and forth.
OBBY_DEVICE Touched touchPart(World& w, const level::LevelView& level, const Candidate& c) {
  const level::Collider& collider = level.colliders[c.collider];
  const level::Roles& r = level.roles[collider.role];
  if (c.flags & level::kPad) touchPad(w, level, r);
  if (c.flags & level::kStarts) {
    for (const uint32_t clock : r.starts) {
      if (clock != level::kNone) startClock(w, level, clock);
    }
  }
  if (c.flags & level::kHeal) touchHeal(w, level, r);
  if (c.flags & level::kKill) touchKill(w, level, collider);
  if (w.outcome != Outcome::running) return Touched::elsewhere;
  if ((c.flags & level::kSeat) && sitDown(w, level, r.seatClock, *c.pose)) {
    return Touched::elsewhere;
  }
  if (!(c.flags & level::kTeleport)) return Touched::stays;
  if (w.flags & kArrived) return Touched::inTeleporter;
  teleport(w, r);
  return Touched::elsewhere;
}

OBBY_DEVICE void touchParts(World& w, const level::LevelView& level, const Candidates& near) {
  bool inTeleporter = false;
  if (near.anyFlags & level::kTouchRoles) {
    const Limbs limbs = limbsOf(w, level.params);
    uint32_t done = level::kNone;  // adjacent hulls of one part are touched once
    for (int k = 0; k < near.count; ++k) {
      const Candidate& c = near.items[k];
      if (!(c.flags & level::kTouchRoles)) continue;
      const level::Collider& collider = level.colliders[c.collider];
      if (collider.part == done) continue;
      const bool footed = k == near.footedOn && !(c.flags & level::kByRoot);
      if (!footed && !touches(collider, c, limbs)) continue;
      done = collider.part;
      const Touched after = touchPart(w, level, c);
      if (after == Touched::elsewhere) return;
      inTeleporter |= after == Touched::inTeleporter;
    }
  }
  if (!inTeleporter) w.flags &= uint8_t(~kArrived);
}

}  // namespace obby::sim
