// The player and dynamic bodies in one tick. The player pushes them with its torso and stands on
// them with its weight; they push the player.
#pragma once

#include "sim/body.h"
#include "sim/body_step.h"

namespace obby::sim {

// Returns the inverse effective mass for an impulse along `n`, at `at` from the centre.
OBBY_DEVICE float yield(const Rigid& b, Vec3 at, Vec3 n) {
  const Vec3 turn = cross(at, n);
  return b.inverseMass + dot(turn, b.inverseInertia * turn);
}

OBBY_DEVICE void push(Rigid& b, Vec3 at, Vec3 impulse) {
  b.velocity += impulse * b.inverseMass;
  b.spin += b.inverseInertia * cross(at, impulse);
}

OBBY_DEVICE Vec3 velocityAt(const Rigid& b, Vec3 at) { return b.velocity + cross(b.spin, at); }

// Wakes the bodies that the player touches. Returns false if all are asleep, so that the player
// moves alone.
OBBY_APART bool wakeTouched(World& w, RigidBody* bodies, const Floor& floor, const Motion& m,
                            const level::LevelView& level, const Candidates& near) {
  if (level.bodyCount == 0) return false;
  bool awake = (w.flags & kBodyAwake) != 0;
  if (floor.body != level::kNoBody) {
    wake(bodies[floor.body]);
    awake = true;
  }
  if (!(near.anyFlags & level::kDynamic)) return awake;
  for (CandidateSet left = solidsInReach(m, level, near); left != 0; left &= left - 1) {
    const Candidate& c = near.items[lowestBit(left)];
    if (!(c.flags & level::kDynamic)) continue;
    wake(bodies[level.colliders[c.collider].body]);
    awake = true;
  }
  return awake;
}

// Applies the weight of a player who stands on a body, and the reaction to its walking.
OBBY_DEVICE void loadFloor(BodyScene& scene, const Motion& m, const Floor& floor, const Params& p,
                           float dt) {
  Rigid& b = scene.bodies[floor.body];
  const Vec3 pressed = acceleration(m, p) + Vec3{0, m.drive.gravity, 0};
  const Vec3 at{m.position.x, m.floorY, m.position.z};
  push(b, at - b.position, pressed * (-p.playerMass * dt));
  b.restless = true;
}

// Returns the point at which the torso presses on a body, relative to the body's centre.
OBBY_DEVICE Vec3 pressedAt(const Rigid& b, const geom::Convex& shape, const geom::UprightBox& box,
                           const geom::Contact& contact) {
  const geom::Convex torso{geom::ShapeKind::block, {box.half, nullptr}, {box.center, box.axes()}};
  const geom::Manifold where =
      geom::manifold(shape, torso, {-contact.depth, contact.normal}, contact.depth);
  Vec3 sum{};
  for (int i = 0; i < where.count; ++i) sum += where.points[i].position;
  return where.count > 0 ? sum * (1.0f / float(where.count)) - b.position : box.center - b.position;
}

// Applies the impulse that ends the approach of the player and a body, and moves the player out.
OBBY_DEVICE void bump(Motion& m, Rigid& b, const level::Collider& collider, const Pose& pose,
                      const level::LevelView& level, float dt) {
  const Params& p = level.params;
  const geom::UprightBox box = bodyBox(m, p);
  const geom::Convex shape = convexOf(collider, pose);
  if (!overlaps(box.bounds(), boundsOf(pose, collider.shape.half))) return;
  const geom::Contact contact = geom::penetration(shape.kind, shape.shape, pose, box);
  if (!(contact.depth > p.contactSkin)) return;
  b.restless = true;
  const Vec3 n = contact.normal, at = pressedAt(b, shape, box, contact);
  const float speed = dot(m.velocity - velocityAt(b, at), n);
  if (speed < 0) {
    const float wanted = -speed / (1 / p.playerMass + yield(b, at, n));
    push(b, at, n * -minf(wanted, p.pushForce * dt));
    // A body that yields too little stops the player.
    m.velocity += n * maxf(dot(velocityAt(b, at) - m.velocity, n), 0.0f);
  }
  m.position += n * (contact.depth - p.contactSkin);
}

struct Solids {
  CandidateSet fixed, bodies;
};

// Sets the floor's speed from the body under the player in each substep, so that a player on a
// falling body falls with it.
OBBY_DEVICE void followFloor(const BodyScene& scene, Motion& m, const Floor& floor) {
  const Rigid& b = scene.bodies[floor.body];
  m.floorSpeed = velocityAt(b, Vec3{m.position.x, m.floorY, m.position.z} - b.position).y;
}

// Moves the player among the bodies for one step of `dt` seconds.
OBBY_DEVICE void stepPlayer(BodyScene& scene, Motion& m, const Floor& floor,
                            const level::LevelView& level, const Candidates& near,
                            const Solids& solids, float dt) {
  const bool onBody = floor.body != level::kNoBody && m.drive.hover;
  if (onBody) {
    followFloor(scene, m, floor);
    loadFloor(scene, m, floor, level.params, dt);
  }
  accelerate(m, level, dt);
  const Vec3 from = m.position;
  m.position += m.velocity * dt;
  if (onBody) m.floorY += m.floorSpeed * dt;
  for (CandidateSet left = solids.bodies; left != 0; left &= left - 1) {
    const level::Collider& c = level.colliders[near.items[lowestBit(left)].collider];
    Rigid& b = scene.bodies[c.body];
    bump(m, b, c, poseOf(b, level.bodies[c.body]), level, dt);
  }
  // Parts come last, so that nothing presses the player into them.
  endMove(m, from, level, near, solids.fixed);
}

// Bodies that have been slow for long enough fall asleep, together with all that they touch.
OBBY_DEVICE void settle(const BodyScene& scene, RigidBody* bodies, const level::LevelView& level) {
  const Params& p = level.params;
  const int count = int(level.bodyCount);
  uint32_t tired = 0;
  for (int i = 0; i < count; ++i) {
    const Rigid& b = scene.bodies[i];
    if (!b.moves) {
      tired |= 1u << i;
      continue;
    }
    bodies[i].stillTicks = uint16_t(stillTicksOf<float>(
        b, level.bodies[i].radius, b.restless || !b.touches, bodies[i].stillTicks, p));
    if (bodies[i].stillTicks >= p.sleepTicks) tired |= 1u << i;
  }
  for (int i = 0; i < count; ++i) {
    uint32_t group = 1u << i, known = 0;
    while (group != known) {
      known = group;
      for (int j = 0; j < count; ++j) {
        if (known >> j & 1) group |= scene.bodies[j].linked;
      }
    }
    if (!scene.bodies[i].moves || (group & ~tired) != 0) continue;
    bodies[i].state = RigidBodyState::asleep;
    bodies[i].velocity = bodies[i].spin = {};
  }
}

OBBY_DEVICE void noteAwake(World& w, const RigidBody* bodies, const level::LevelView& level) {
  w.flags &= uint8_t(~kBodyAwake);
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    if (bodies[i].state == RigidBodyState::awake) w.flags |= kBodyAwake;
  }
}

OBBY_DEVICE void putBodies(const BodyScene& scene, RigidBody* bodies,
                           const level::LevelView& level) {
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    const Rigid& b = scene.bodies[i];
    if (!b.moves) continue;
    bodies[i].position = b.position, bodies[i].rotation = b.rotation;
    // Impulses since the last move may have exceeded the max speeds.
    bodies[i].velocity = limited(b.velocity, level.params.maxFallSpeed);
    bodies[i].spin = limited(b.spin, kMaxSpin);
    if (b.position.y < level.params.fallenPartsHeight) bodies[i].state = RigidBodyState::gone;
  }
  settle(scene, bodies, level);
}

// Moves a group of bodies by one tick, and the player with it if it is not null.
OBBY_APART void moveGroup(World& w, RigidBody* bodies, const BodyGroup& group, Motion* player,
                          const Floor& floor, const level::LevelView& level, Candidates& near) {
  const Params& p = level.params;
  BodyScene scene;
  findContacts(w, bodies, level, group, scene);
  estimateLoads(scene, int(level.bodyCount), p, p.substepSeconds);
  Solids solids{0, 0};
  int splits = 1;
  if (player) {
    const CandidateSet all = solidsInReach(*player, level, near);
    for (CandidateSet left = all; left != 0; left &= left - 1) {
      const CandidateSet bit = left & (0 - left);
      (near.items[lowestBit(left)].flags & level::kDynamic ? solids.bodies : solids.fixed) |= bit;
    }
    if (all) splits = contactSplits(*player, p);
  }
  // Bodies move first, so that a player on a falling body gains the same speed in the substep.
  for (int s = 0; s < p.substeps; ++s) {
    stepBodies(scene, int(level.bodyCount), p, p.substepSeconds);
    for (int i = 0; player && i < splits; ++i) {
      stepPlayer(scene, *player, floor, level, near, solids, p.substepSeconds / float(splits));
    }
  }
  bounce(scene);
  putBodies(scene, bodies, level);
  // Touches are tested with the poses at the tick's end.
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    if (scene.bodies[i].moves) near.bodies[i] = poseOf(scene.bodies[i], level.bodies[i]);
  }
}

// Returns true if the body meets no other in this tick.
OBBY_DEVICE bool isAlone(const RigidBody* bodies, const level::LevelView& level, uint32_t body) {
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    if (i == body || bodies[i].state == RigidBodyState::gone) continue;
    const level::DynamicBody &one = level.bodies[body], &other = level.bodies[i];
    if (mayMeet(bodies[body], bodies[i], one, other, level.params)) return false;
  }
  return true;
}

// Moves all awake bodies by one tick, and the player with them. The player is null if it has moved
// already. Bodies that meet only parts are moved one by one, as in lanes.
OBBY_APART void moveTogether(World& w, RigidBody* bodies, Motion* player, const Floor& floor,
                             const level::LevelView& level, Candidates& near) {
  BodyGroup together{0, false};
  uint32_t alone = 0;
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    const uint32_t bit = 1u << i;
    if (bodies[i].state != RigidBodyState::awake || (near.bodiesApart & bit)) continue;
    const bool meets = (player && (near.bodiesNear & bit)) || !isAlone(bodies, level, i);
    (meets ? together.bodies : alone) |= bit;
  }
  if (player || together.bodies) moveGroup(w, bodies, together, player, floor, level, near);
  for (; alone != 0; alone &= alone - 1) {
    moveGroup(w, bodies, {alone & (0 - alone), true}, nullptr, floor, level, near);
  }
  for (int k = 0; k < near.count && (near.items[k].flags & level::kDynamic); ++k) {
    Candidate& c = near.items[k];  // bodies are the first items
    c.bounds = boundsOf(*c.pose, level.colliders[c.collider].shape.half);
  }
  noteAwake(w, bodies, level);
}

}  // namespace obby::sim
