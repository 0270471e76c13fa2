// The physics of one tick: substeps of gravity, drive and hover spring, and the torso and head
// pushed out of parts.
#pragma once

#include "geom/penetration.h"
#include "sim/humanoid.h"

namespace obby::sim {

// Torso and head as one upright box; the torso does not collide while jumping.
OBBY_DEVICE geom::UprightBox bodyBox(const World& w, const Params& p, SinCos yaw) {
  const float bottom = w.state == State::jumping ? p.headBottom : p.hipHeight;
  const float half = (p.bodyTop - bottom) * 0.5f;
  return {
      w.position + Vec3{0, bottom + half, 0}, {p.bodyWidth * 0.5f, half, p.bodyDepth * 0.5f}, yaw};
}

// Acceleration of a substep.
OBBY_DEVICE Vec3 acceleration(const World& w, const Params& p, const Floor& floor, const Drive& d,
                              float gap) {
  Vec3 a{(d.velocity.x - w.velocity.x) * p.moveGain, 0, (d.velocity.z - w.velocity.z) * p.moveGain};
  const float size2 = a.x * a.x + a.z * a.z;
  if (size2 > d.limit * d.limit) a = a * (d.limit / sqrtf32(size2));
  a += d.slide;
  a.y = -p.gravity;
  if (d.hover) {
    const float lift = -p.hoverStiffness * gap - p.hoverDamping * (w.velocity.y - floor.velocity.y);
    if (lift > -p.hoverPull) a.y = lift;  // the legs push, they do not pull
  }
  return a;
}

OBBY_DEVICE void limitSpeed(World& w, const level::LevelView& level) {
  const float most = level.params.maxFallSpeed, side = level.maxSideSpeed;
  w.velocity.y = clampf(w.velocity.y, -most, most);
  w.velocity.x = clampf(w.velocity.x, -side, side);
  w.velocity.z = clampf(w.velocity.z, -side, side);
}

// Pushes the body out of one part; true if it was inside by more than the skin.
OBBY_DEVICE bool pushOut(World& w, const level::LevelView& level, const Candidate& c,
                         const geom::UprightBox& box) {
  const level::Collider& collider = level.colliders[c.collider];
  const geom::Contact contact = geom::penetration(collider.kind, collider.shape, *c.pose, box);
  if (contact.depth <= level.params.contactSkin) return false;
  w.position += contact.normal * (contact.depth - level.params.contactSkin);
  const float into = dot(w.velocity, contact.normal);
  if (into < 0) w.velocity -= contact.normal * into;
  return true;
}

// Two rounds over the parts near the body, in their order: corners need the second.
OBBY_DEVICE void collide(World& w, const level::LevelView& level, const Candidates& near,
                         SinCos yaw) {
  for (int round = 0; round < 2; ++round) {
    bool pushed = false;
    for (int k = 0; k < near.count; ++k) {
      const Candidate& c = near.items[k];
      if (!(c.flags & level::kSolid)) continue;
      const geom::UprightBox box = bodyBox(w, level.params, yaw);
      if (overlaps(box.bounds(), c.bounds)) pushed |= pushOut(w, level, c, box);
    }
    if (!pushed) return;
  }
}

// Can the body meet anything solid during this tick? Decides whether substeps look at all.
OBBY_DEVICE bool mayCollide(const World& w, const level::LevelView& level, const Candidates& near,
                            SinCos yaw) {
  if (!(near.anyFlags & level::kSolid)) return false;
  const Params& p = level.params;
  const float dt = p.tickSeconds;
  // Speed now, and what gravity, drive and spring can add in a tick (a tenth of a stud is more than
  // they do sideways; up and down the spring may add more).
  const Vec3 move = abs(w.velocity) * dt + Vec3{0.2f, 0.5f + p.gravity * dt * dt, 0.2f};
  const Box box = grow(bodyBox(w, p, yaw).bounds(), move);
  for (int k = 0; k < near.count; ++k) {
    if ((near.items[k].flags & level::kSolid) && overlaps(near.items[k].bounds, box)) return true;
  }
  return false;
}

OBBY_DEVICE void moveBody(World& w, const level::LevelView& level, const Candidates& near,
                          const Floor& floor, const Drive& d) {
  const Params& p = level.params;
  const float dt = p.substepSeconds;
  const SinCos yaw = sinCos(w.yaw);
  const bool solids = mayCollide(w, level, near, yaw);
  const float floorY = w.position.y - floor.gap;
  for (int s = 0; s < p.substeps; ++s) {
    const Vec3 a = acceleration(w, p, floor, d, w.position.y - floorY);
    w.position += w.velocity * dt +
                  a * (0.5f * dt * dt);  // exact for constant acceleration: jumps are parabolas
    w.velocity += a * dt;
    limitSpeed(w, level);
    if (solids) collide(w, level, near, yaw);
  }
}

}  // namespace obby::sim
