// The contacts of a world's dynamic bodies with parts and with each other. They are found once, at
// the start of the tick, and include everything that can be met before its end.
#pragma once

#include "geom/manifold.h"
#include "sim/body_contact.h"
#include "sim/body_partner.h"
#include "sim/candidates.h"

namespace obby::sim {

constexpr int kMaxBodyContacts = 64;  // max contacts of a world; more set kContactOverrun

struct Rigid : RigidT<float> {
  uint32_t linked;  // bodies that this body touches, itself included, one bit each
  bool moves;       // awake in this tick
  bool restless;    // something near the body moves or may vanish, so it must not fall asleep
  bool touches;     // has a contact
};

using Pair = PairT<float>;

struct BodyContact : BodyContactT<float, 2> {
  int a, b;  // bodies; b is kPart for a part
};

// Bodies that may meet each other, with or without the player.
struct BodyScene {
  // Unions leave the arrays uninitialised, because filling them in every tick is slow.
  union {
    Rigid bodies[level::kMaxBodies + 1];  // the last stands for all parts and does not move
  };
  union {
    BodyContact contacts[kMaxBodyContacts];
  };
  int contactCount = 0;

  OBBY_DEVICE BodyScene() {}
};

// Returns the distance up to which two shapes at this speed have a contact.
OBBY_DEVICE float contactMargin(const Params& p, float speed) {
  return 2 * p.contactSkin + speed * p.tickSeconds;
}

// Returns the box around a body, extended by `margin`.
OBBY_DEVICE Box reachOf(Vec3 position, const level::DynamicBody& l, float margin) {
  const float reach = l.radius + margin;
  return {position - Vec3{reach, reach, reach}, position + Vec3{reach, reach, reach}};
}

// Returns true if two bodies could touch during the tick. Body is RigidBody or Rigid.
template <class Body>
OBBY_DEVICE bool mayMeet(const Body& a, const Body& b, const level::DynamicBody& la,
                         const level::DynamicBody& lb, const Params& p) {
  const Vec3 d = b.position - a.position;
  const float reach = la.radius + lb.radius + contactMargin(p, length(a.velocity - b.velocity));
  return dot(d, d) <= reach * reach;
}

// Returns true if a part with these flags keeps bodies on it from falling asleep.
OBBY_DEVICE bool isRestless(uint32_t flags) {
  return (flags & (kLeaves | level::kMoving | level::kConveyor)) != 0;
}

OBBY_DEVICE Rigid rigidOf(const RigidBody& b, const level::DynamicBody& l) {
  return {
      rigidOf<float>(b.position, b.velocity, b.spin, b.rotation, l.inverseInertia, l.inverseMass),
      0, false, false, false};
}

// Returns the pose of the body's part within the tick.
OBBY_DEVICE Pose poseOf(const Rigid& b, const level::DynamicBody& l) {
  return partPose(l, b.position, b.axes);
}

OBBY_DEVICE Pair pairOf(const BodyScene& s, const BodyContact& c) {
  const Rigid &a = s.bodies[c.a], &b = s.bodies[c.b];
  return {{a.velocity, c.b == kPart ? c.surface : b.velocity},
          {a.spin, b.spin},
          {a.inverseMass, b.inverseMass}};
}

OBBY_DEVICE void putPair(BodyScene& s, const BodyContact& c, const Pair& p) {
  s.bodies[c.a].velocity = p.velocity[0], s.bodies[c.a].spin = p.spin[0];
  if (c.b == kPart) return;
  s.bodies[c.b].velocity = p.velocity[1], s.bodies[c.b].spin = p.spin[1];
}

OBBY_APART void addContact(World& w, const level::LevelView& level, BodyScene& scene, int a,
                           const level::Collider& own, const Partner& other,
                           const geom::Manifold& m) {
  if (m.count == 0) return;
  if (scene.contactCount == kMaxBodyContacts) {
    w.flags |= kContactOverrun;
    return;
  }
  BodyContact& c = scene.contacts[scene.contactCount++];
  c.a = a, c.b = other.body;
  scene.bodies[c.a].touches = scene.bodies[c.b].touches = true;
  c.normal = m.normal;
  c.friction = 0.5f * (own.friction + other.collider->friction);
  c.bounce = 0.5f * (own.elasticity + other.collider->elasticity);
  const Vec3 middle = middleOf<float>(m);
  const Vec3 moved = movedBy(level, other, middle);
  c.surface = surfaceOf(level, other, middle, m.normal, moved);
  c.comes = dot(moved, m.normal);
  const RigidT<float>* const bodies[2] = {&scene.bodies[a], &scene.bodies[other.body]};
  prepare<float, 2>(c, bodies, pairOf(scene, c), m, middle, level.params.tickSeconds);
}

// Links two touching bodies. Linked bodies fall asleep together, so this wakes a body that sleeps.
OBBY_DEVICE void link(BodyScene& scene, RigidBody* bodies, int a, int b) {
  scene.bodies[a].linked |= 1u << b;
  scene.bodies[b].linked |= 1u << a;
  if (scene.bodies[b].moves) return;
  wake(bodies[b]);
  scene.bodies[b].moves = true;
}

// Tests all colliders of body `a` against a partner.
OBBY_APART void meet(World& w, RigidBody* bodies, const level::LevelView& level, BodyScene& scene,
                     int a, const Partner& other, float margin) {
  const level::DynamicBody& l = level.bodies[a];
  const Pose pose = poseOf(scene.bodies[a], l);
  for (uint32_t i = 0; i < l.colliderCount; ++i) {
    const level::Collider& own = level.colliders[l.firstCollider + i];
    const geom::Convex shape = convexOf(own, pose);
    const geom::Separation s = geom::separation(shape, other.convex, margin);
    if (s.distance > margin) continue;
    const geom::Manifold m = geom::manifold(shape, other.convex, s, margin);
    if (other.body != kPart && m.count > 0) link(scene, bodies, a, other.body);
    addContact(w, level, scene, a, own, other, m);
  }
}

// Tests the parts near body `a`. One-way parts are solid to a body from every side.
OBBY_APART void meetParts(World& w, RigidBody* bodies, const level::LevelView& level,
                          BodyScene& scene, int a) {
  Rigid& body = scene.bodies[a];
  const int32_t cell = cellOf<float>(level.bodyGrid, body.position);
  if (cell < 0) return;
  const float margin = contactMargin(level.params, length(body.velocity));
  const Box near = reachOf(body.position, level.bodies[a], margin);
  const uint32_t* list = level.bodyGrid.lists + level.bodyGrid.cells[cell];
  for (uint32_t i = 1; i <= list[0]; ++i) {
    const level::Bounds& bounds = level.bounds[list[i]];
    if (!(bounds.flags & level::kSolid) || !overlaps(bounds.box(), near)) continue;
    const level::Collider& c = level.colliders[list[i]];
    const uint32_t flags = bounds.flags;
    Partner part{convexOf(c, c.pose), kPart, &c, flags, c.pose};
    if (isRestless(flags)) body.restless = true;
    if (hasLeft(w, level, c, flags)) continue;
    if (flags & level::kMoving) {
      part.convex.pose = poseOf(level.movers[c.mover], w, 1);
      part.before = poseOf(level.movers[c.mover], w, 0);
      if (!overlaps(boundsOf(part.convex.pose, c.shape.half), near)) continue;
    }
    meet(w, bodies, level, scene, a, part, margin);
  }
}

OBBY_APART void meetBodies(World& w, RigidBody* bodies, const level::LevelView& level,
                           BodyScene& scene, int a, uint32_t done) {
  for (int b = 0; b < int(level.bodyCount); ++b) {
    const Rigid &one = scene.bodies[a], &other = scene.bodies[b];
    if (bodies[b].state == RigidBodyState::gone || (done >> b & 1)) continue;
    const level::DynamicBody& l = level.bodies[b];
    if (!mayMeet(one, other, level.bodies[a], l, level.params)) continue;
    const float margin = contactMargin(level.params, length(one.velocity - other.velocity));
    const Pose pose = poseOf(other, l);
    for (uint32_t i = 0; i < l.colliderCount; ++i) {
      const level::Collider& c = level.colliders[l.firstCollider + i];
      meet(w, bodies, level, scene, a, {convexOf(c, pose), b, &c, 0, pose}, margin);
    }
  }
}

// The bodies of a world that move together, one bit each. `alone` is true for a single body that
// meets no other, so that no other is tested.
struct BodyGroup {
  uint32_t bodies;
  bool alone;
};

OBBY_DEVICE void putRigids(const RigidBody* bodies, const level::LevelView& level,
                           const BodyGroup& group, BodyScene& scene) {
  scene.bodies[kPart] = {};
  scene.bodies[kPart].inverseInertia = {{}, {}, {}};
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    const bool moves = (group.bodies >> i & 1) != 0;
    Rigid& body = scene.bodies[i];
    if (moves || !group.alone) body = rigidOf(bodies[i], level.bodies[i]);
    body.linked = 1u << i;
    body.moves = moves;
  }
}

// Finds the contacts of a group of awake bodies, and of the bodies that they wake.
OBBY_DEVICE void findContacts(World& w, RigidBody* bodies, const level::LevelView& level,
                              const BodyGroup& group, BodyScene& scene) {
  const int count = int(level.bodyCount);
  putRigids(bodies, level, group, scene);
  uint32_t done = 0;
  // A body that a later one woke has its turn in the next pass.
  for (bool more = true; more;) {
    more = false;
    for (int i = 0; i < count; ++i) {
      if (!scene.bodies[i].moves || (done >> i & 1)) continue;
      done |= 1u << i;
      more = true;
      meetParts(w, bodies, level, scene, i);
      if (!group.alone) meetBodies(w, bodies, level, scene, i, done);
    }
  }
}

}  // namespace obby::sim
