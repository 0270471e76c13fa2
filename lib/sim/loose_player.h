// The player and loose bodies in one tick: it pushes them with its torso, stands on them with its
// weight, and is pushed by them.
#pragma once

#include "sim/body.h"
#include "sim/loose_solver.h"

namespace obby::sim {

// Wakes what the player touches. False: all loose bodies are asleep, and the player moves alone.
OBBY_APART bool wakeTouched(World& w, LooseBody* loose, const Floor& floor, const Motion& m,
                            const level::LevelView& level, const Candidates& near) {
  if (level.looseCount == 0) return false;
  bool awake = (w.flags & kLooseAwake) != 0;
  if (floor.loose != level::kNotLoose) {
    wake(loose[floor.loose]);
    awake = true;
  }
  if (!(near.anyFlags & level::kLoose)) return awake;
  for (CandidateSet left = solidsInReach(m, level, near); left != 0; left &= left - 1) {
    const Candidate& c = near.items[lowestBit(left)];
    if (!(c.flags & level::kLoose)) continue;
    wake(loose[level.colliders[c.collider].loose]);
    awake = true;
  }
  return awake;
}

// The weight of a player who stands on a body, and what its walking asks of it.
OBBY_DEVICE void loadFloor(LooseScene& scene, const Motion& m, const Floor& floor, const Params& p,
                           float dt) {
  Rigid& b = scene.bodies[floor.loose];
  const Vec3 pressed = acceleration(m, p) + Vec3{0, p.gravity, 0};
  const Vec3 at{m.position.x, m.floorY, m.position.z};
  push(b, at - b.position, pressed * (-p.playerMass * dt));
  b.restless = true;
}

// Where the torso presses on a body, from the body's centre.
OBBY_DEVICE Vec3 pressedAt(const Rigid& b, const geom::Convex& shape, const geom::UprightBox& box,
                           const geom::Contact& contact) {
  const geom::Convex torso{geom::ShapeKind::block, {box.half, nullptr}, {box.center, box.axes()}};
  const geom::Manifold where =
      geom::manifold(shape, torso, {-contact.depth, contact.normal}, contact.depth);
  Vec3 sum{};
  for (int i = 0; i < where.count; ++i) sum += where.points[i].position;
  return where.count > 0 ? sum * (1.0f / float(where.count)) - b.position : box.center - b.position;
}

// Exchanges the impulse that ends the approach of the player and a body, and moves the player out.
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
    // What the body does not yield stops the player.
    m.velocity += n * maxf(dot(velocityAt(b, at) - m.velocity, n), 0.0f);
  }
  m.position += n * (contact.depth - p.contactSkin);
}

struct Solids {
  CandidateSet fixed, loose;
};

// The speed of the floor's body within the tick: a player who stands on one that falls falls with
// it.
OBBY_DEVICE void followFloor(const LooseScene& scene, Motion& m, const Floor& floor) {
  const Rigid& b = scene.bodies[floor.loose];
  m.floorSpeed = velocityAt(b, Vec3{m.position.x, m.floorY, m.position.z} - b.position).y;
}

// One step of the player among the bodies, `dt` long.
OBBY_DEVICE void stepPlayer(LooseScene& scene, Motion& m, const Floor& floor,
                            const level::LevelView& level, const Candidates& near,
                            const Solids& solids, float dt) {
  const bool onBody = floor.loose != level::kNotLoose && m.drive.hover;
  if (onBody) {
    followFloor(scene, m, floor);
    loadFloor(scene, m, floor, level.params, dt);
  }
  integrate(m, level, dt);
  if (onBody) m.floorY += m.floorSpeed * dt;
  for (CandidateSet left = solids.loose; left != 0; left &= left - 1) {
    const level::Collider& c = level.colliders[near.items[lowestBit(left)].collider];
    Rigid& b = scene.bodies[c.loose];
    bump(m, b, c, poseOf(b, level.loose[c.loose]), level, dt);
  }
  // Parts come last: nothing presses the player into them.
  if (solids.fixed) collide(m, level, near, solids.fixed);
}

// Bodies that have been slow for long fall asleep together with all that they touch.
OBBY_DEVICE void settle(const LooseScene& scene, LooseBody* loose, const level::LevelView& level) {
  const Params& p = level.params;
  const int count = int(level.looseCount);
  uint32_t tired = 0;
  for (int i = 0; i < count; ++i) {
    const Rigid& b = scene.bodies[i];
    if (!b.moves) {
      tired |= 1u << i;
      continue;
    }
    const float turning = length(b.spin) * level.loose[i].radius;
    const bool slow = length(b.velocity) < p.sleepSpeed && turning < p.sleepSpeed;
    const uint16_t more = uint16_t(loose[i].stillTicks < 0xffff ? loose[i].stillTicks + 1 : 0xffff);
    loose[i].stillTicks = slow && !b.restless ? more : uint16_t(0);
    if (loose[i].stillTicks >= p.sleepTicks) tired |= 1u << i;
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
    loose[i].state = LooseState::asleep;
    loose[i].velocity = loose[i].spin = {};
  }
}

OBBY_DEVICE void putBodies(const LooseScene& scene, World& w, LooseBody* loose,
                           const level::LevelView& level) {
  w.flags &= uint8_t(~kLooseAwake);
  for (uint32_t i = 0; i < level.looseCount; ++i) {
    const Rigid& b = scene.bodies[i];
    if (!b.moves) continue;
    loose[i].position = b.position, loose[i].rotation = b.rotation;
    // Impulses since the last move may have made it faster than a body can be.
    loose[i].velocity = limited(b.velocity, level.params.maxFallSpeed);
    loose[i].spin = limited(b.spin, kMostSpin);
    if (b.position.y < level.params.fallenPartsHeight) loose[i].state = LooseState::gone;
  }
  settle(scene, loose, level);
  for (uint32_t i = 0; i < level.looseCount; ++i) {
    if (loose[i].state == LooseState::awake) w.flags |= kLooseAwake;
  }
}

// Moves the player and all bodies that are awake by one tick. `player` is null where it has moved
// already.
OBBY_APART void moveTogether(World& w, LooseBody* loose, Motion* player, const Floor& floor,
                             const level::LevelView& level, Candidates& near) {
  const Params& p = level.params;
  LooseScene scene;
  findContacts(w, loose, level, scene);
  estimateLoads(scene, int(level.looseCount), p, p.substepSeconds);
  Solids solids{0, 0};
  int splits = 1;
  if (player) {
    const CandidateSet all = solidsInReach(*player, level, near);
    for (CandidateSet left = all; left != 0; left &= left - 1) {
      const CandidateSet bit = left & (0 - left);
      (near.items[lowestBit(left)].flags & level::kLoose ? solids.loose : solids.fixed) |= bit;
    }
    if (all) splits = contactSubsteps(*player, p) / p.substeps;
  }
  // Bodies first: what a falling one has gained in the substep, the player on it has as well.
  for (int s = 0; s < p.substeps; ++s) {
    stepBodies(scene, int(level.looseCount), p, p.substepSeconds);
    for (int i = 0; player && i < splits; ++i) {
      stepPlayer(scene, *player, floor, level, near, solids, p.substepSeconds / float(splits));
    }
  }
  for (int i = 0; i < scene.contactCount; ++i) applyBounce(scene, scene.contacts[i]);
  putBodies(scene, w, loose, level);
  // What is touched at the tick's end is where it is then.
  for (uint32_t i = 0; i < level.looseCount; ++i) {
    if (scene.bodies[i].moves) near.loose[i] = poseOf(scene.bodies[i], level.loose[i]);
  }
}

}  // namespace obby::sim
