// What happens on touch: limbs against kill parts, jump pads and parts that vanish. Limbs are a
// still pose, arms at the sides: a box as wide as the arms at torso height, and one as wide as the
// torso from the feet to the head.
#pragma once

#include "sim/body.h"

namespace obby::sim {

struct Limbs {
  geom::UprightBox arms, column;
};

OBBY_DEVICE Limbs limbsOf(const World& w, const Params& p) {
  const SinCos yaw = sinCos(w.yaw);
  const float m = p.touchMargin;
  const float armsHalf = (p.headBottom - p.hipHeight) * 0.5f;
  const Vec3 armsCenter = w.position + Vec3{0, p.hipHeight + armsHalf, 0};
  const Vec3 columnCenter = w.position + Vec3{0, p.bodyTop * 0.5f, 0};
  return {{armsCenter, Vec3{p.armSpan * 0.5f + m, armsHalf + m, p.bodyDepth * 0.5f + m}, yaw},
          {columnCenter, Vec3{p.bodyWidth * 0.5f + m, p.bodyTop * 0.5f + m, p.bodyDepth * 0.5f + m},
           yaw}};
}

OBBY_DEVICE bool touches(const level::Collider& collider, const Candidate& c,
                         const geom::UprightBox& box) {
  return overlaps(box.bounds(), c.bounds) && contactWith(collider, c, box).depth >= 0;
}

OBBY_DEVICE void touchKill(World& w, const level::LevelView& level, const level::Collider& c) {
  const level::Roles& r = level.roles[c.role];
  if (w.hurtTicks > 0 && r.damage < w.health) return;
  w.health -= r.damage;
  w.hurtTicks = r.cooldownTicks;
  if (w.health > 0) return;
  w.state = State::dead;
  w.outcome = Outcome::killed;
  w.part = c.part;
}

OBBY_DEVICE void touchPad(World& w, const level::Roles& r) {
  const float speed = length(r.padVelocity);
  if (speed <= 0) return;
  const Vec3 along = r.padVelocity * (1.0f / speed);
  const float now = dot(w.velocity, along);
  if (now > 0.9f * speed) return;  // launched already
  w.velocity = r.padKeepsSideways ? w.velocity + along * (speed - now) : r.padVelocity;
  w.state = State::freefall;
  w.floorlessTicks = 0xffff;
  w.flags &= uint8_t(~kFloorSensed);
}

OBBY_DEVICE void touchVanish(World& w, uint32_t role) {
  for (int i = 0; i < w.vanishingCount; ++i) {
    if (w.vanishing[i].role == role) return;
  }
  if (w.vanishingCount == kMaxVanishing) {
    w.flags |= kVanishOverrun;
    return;
  }
  w.vanishing[w.vanishingCount++] = {role, 0};
}

OBBY_DEVICE void touchParts(World& w, const level::LevelView& level, const Candidates& near) {
  if (!(near.anyFlags & level::kTouchRoles)) return;
  const Limbs limbs = limbsOf(w, level.params);
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if (!(c.flags & level::kTouchRoles)) continue;
    const level::Collider& collider = level.colliders[c.collider];
    if (!touches(collider, c, limbs.column) && !touches(collider, c, limbs.arms)) continue;
    if (c.flags & level::kPad) touchPad(w, level.roles[collider.role]);
    if (c.flags & level::kVanishTouch) touchVanish(w, collider.role);
    if (c.flags & level::kKill) touchKill(w, level, collider);
    if (w.outcome != Outcome::running) return;
  }
}

// Lets the clocks of touched parts run; parts that are back are forgotten. Order is kept.
OBBY_DEVICE void runVanishing(World& w, const level::LevelView& level) {
  int kept = 0;
  for (int i = 0; i < w.vanishingCount; ++i) {
    const level::Roles& r = level.roles[w.vanishing[i].role];
    const uint32_t ticks = w.vanishing[i].ticks + 1;
    if (ticks < r.vanishDelay + r.vanishAway) w.vanishing[kept++] = {w.vanishing[i].role, ticks};
  }
  w.vanishingCount = uint8_t(kept);
}

}  // namespace obby::sim
