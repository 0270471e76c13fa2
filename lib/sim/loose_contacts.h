// The contacts of a world's loose bodies for one tick: with parts and with each other. Found once,
// at the start of the tick, with whatever is close enough to be met before its end.
#pragma once

#include "geom/manifold.h"
#include "sim/candidates.h"
#include "sim/loose_partner.h"

namespace obby::sim {

constexpr int kMaxLooseContacts = 64;  // of a world; beyond them it has kContactOverrun

// A body during the tick.
struct Rigid {
  Vec3 position, velocity, spin;
  Quat rotation;
  Mat3 axes;            // of the part
  Mat3 inverseInertia;  // world
  float inverseMass;
  uint32_t linked;  // bodies that it touches, itself included: a bit each
  bool moves;       // awake in this tick
  bool restless;    // something near it moves or may vanish: must not fall asleep
};

// One line along which a contact pushes its bodies apart: a direction through a point, or a turning
// about a direction.
struct Push {
  Vec3 turnA, turnB;      // speed along the line that a unit of spin makes
  Vec3 answerA, answerB;  // spin that a unit of impulse makes
  float mass;             // that resists
  float impulse;          // of the last substep
};

struct ContactPoint {
  Push push;       // along the normal
  float distance;  // gap now
  float most;      // the largest impulse
  float approach;  // speed at the start of the tick; negative: toward each other
};

// A pair; the normal points from body a to b, a body or a part.
struct LooseContact {
  int a, b;      // b = kPart: a part
  Vec3 surface;  // velocity of the part where it is met
  float comes;   // how fast the part itself moves along the normal; negative: toward the body
  Vec3 normal;
  float friction, bounce;
  int count;
  ContactPoint points[geom::kMaxPoints];
  // Friction works in the middle of the points, along two tangents and about the normal.
  Vec3 tangents[2];
  Push slide[2], twist;
  float twistRadius;
};

struct LooseScene {
  Rigid bodies[level::kMaxLoose + 1];  // the last stands for all parts: it does not move
  union {                              // keeps the array from being filled for every tick
    LooseContact contacts[kMaxLooseContacts];
  };
  int contactCount = 0;

  OBBY_DEVICE LooseScene() {}
};

// How close two shapes must be to be a contact of bodies this fast.
OBBY_DEVICE float contactMargin(const Params& p, float speed) {
  return 2 * p.contactSkin + speed * p.tickSeconds;
}

OBBY_DEVICE Rigid rigidOf(const LooseBody& b, const level::Loose& l) {
  const Mat3 axes = toMat3(b.rotation);
  const Mat3 own = axes * l.inverseInertia;
  // axes * inverse * transposed axes, by rows of the transposed.
  const Vec3 rows[3] = {{axes.x.x, axes.y.x, axes.z.x},
                        {axes.x.y, axes.y.y, axes.z.y},
                        {axes.x.z, axes.y.z, axes.z.z}};
  return {b.position,    b.velocity, b.spin,
          b.rotation,    axes,       {own * rows[0], own * rows[1], own * rows[2]},
          l.inverseMass, 0,          b.state == LooseState::awake,
          false};
}

// Of its part within the tick.
OBBY_DEVICE Pose poseOf(const Rigid& b, const level::Loose& l) {
  return partPose(l, b.position, b.axes);
}

// `turnA`, `turnB`: as Push has them; `inverseMass` 0: nothing but a turning.
OBBY_DEVICE Push pushAlong(const Rigid& a, const Rigid& b, Vec3 turnA, Vec3 turnB,
                           float inverseMass) {
  Push p{turnA, turnB, a.inverseInertia * turnA, b.inverseInertia * turnB, 0, 0};
  const float yield = inverseMass + dot(turnA, p.answerA) + dot(turnB, p.answerB);
  p.mass = yield > 0 ? 1 / yield : 0.0f;
  return p;
}

// The bodies of a contact while it is worked on: copies, which stay in registers.
struct Pair {
  Vec3 velocityA, spinA, velocityB, spinB;  // of a part: of its surface, and none
  float massA, massB;                       // inverse
};

OBBY_DEVICE Pair pairOf(const LooseScene& s, const LooseContact& c) {
  const Rigid &a = s.bodies[c.a], &b = s.bodies[c.b];
  const bool isPart = c.b == kPart;
  return {a.velocity, a.spin,        isPart ? c.surface : b.velocity,
          b.spin,     a.inverseMass, b.inverseMass};
}

OBBY_DEVICE void putPair(LooseScene& s, const LooseContact& c, const Pair& p) {
  s.bodies[c.a].velocity = p.velocityA, s.bodies[c.a].spin = p.spinA;
  if (c.b == kPart) return;
  s.bodies[c.b].velocity = p.velocityB, s.bodies[c.b].spin = p.spinB;
}

// Speed of b's surface away from a's along the line; `along` is zero for a turning.
OBBY_DEVICE float speedOf(const Pair& s, const Push& p, Vec3 along) {
  return dot(along, s.velocityB - s.velocityA) + (dot(p.turnB, s.spinB) - dot(p.turnA, s.spinA));
}

// Gives an impulse along the line. A part has no mass to answer with: it stays as it is.
OBBY_DEVICE void pushApart(Pair& s, const Push& p, Vec3 along, float impulse) {
  s.velocityA -= along * (impulse * s.massA);
  s.spinA -= p.answerA * impulse;
  s.velocityB += along * (impulse * s.massB);
  s.spinB += p.answerB * impulse;
}

// Fills in what the solver needs.
OBBY_DEVICE void prepare(const LooseScene& s, LooseContact& c, const geom::Manifold& m, Vec3 middle,
                         float tickSeconds) {
  const Rigid &a = s.bodies[c.a], &b = s.bodies[c.b];
  const float inverseMass = a.inverseMass + b.inverseMass;
  const auto through = [&](Vec3 at, Vec3 n) {
    return pushAlong(a, b, cross(at - a.position, n), cross(at - b.position, n), inverseMass);
  };
  const Pair pair = pairOf(s, c);
  float spread = 0;
  for (int i = 0; i < m.count; ++i) {
    ContactPoint& p = c.points[i];
    const Vec3 at = m.points[i].position;
    p.push = through(at, c.normal);
    // Moving parts are met where they will be at the tick's end.
    p.distance = m.points[i].distance - c.comes * tickSeconds;
    p.most = 0;
    p.approach = speedOf(pair, p.push, c.normal);
    spread += length(at - middle);
  }
  geom::tangentsOf(c.normal, c.tangents[0], c.tangents[1]);
  for (int t = 0; t < 2; ++t) c.slide[t] = through(middle, c.tangents[t]);
  c.twist = pushAlong(a, b, c.normal, c.normal, 0);
  c.twistRadius = spread / float(m.count);
}

OBBY_APART void addContact(World& w, const level::LevelView& level, LooseScene& scene, int a,
                           const level::Collider& own, const Partner& other,
                           const geom::Manifold& m) {
  if (m.count == 0) return;
  if (scene.contactCount == kMaxLooseContacts) {
    w.flags |= kContactOverrun;
    return;
  }
  LooseContact& c = scene.contacts[scene.contactCount++];
  c.a = a, c.b = other.body;
  c.normal = m.normal;
  c.friction = 0.5f * (own.friction + other.collider->friction);
  c.bounce = 0.5f * (own.elasticity + other.collider->elasticity);
  c.count = m.count;
  Vec3 middle{};
  for (int i = 0; i < m.count; ++i) middle += m.points[i].position;
  middle = middle * (1.0f / float(m.count));
  const Vec3 moved = movedBy(level, other, middle);
  c.surface = surfaceOf(level, other, middle, m.normal, moved);
  c.comes = dot(moved, m.normal);
  prepare(scene, c, m, middle, level.params.tickSeconds);
}

// Bodies that touch share their rest: one that sleeps wakes up.
OBBY_DEVICE void link(LooseScene& scene, LooseBody* loose, int a, int b) {
  scene.bodies[a].linked |= 1u << b;
  scene.bodies[b].linked |= 1u << a;
  if (scene.bodies[b].moves) return;
  wake(loose[b]);
  scene.bodies[b].moves = true;
}

// All colliders of body `a` against a partner.
OBBY_APART void meet(World& w, LooseBody* loose, const level::LevelView& level, LooseScene& scene,
                     int a, const Partner& other, float margin) {
  const level::Loose& l = level.loose[a];
  const Pose pose = poseOf(scene.bodies[a], l);
  for (uint32_t i = 0; i < l.colliderCount; ++i) {
    const level::Collider& own = level.colliders[l.firstCollider + i];
    const geom::Convex shape = convexOf(own, pose);
    const geom::Separation s = geom::separation(shape, other.convex, margin);
    if (s.distance > margin) continue;
    const geom::Manifold m = geom::manifold(shape, other.convex, s, margin);
    if (other.body != kPart && m.count > 0) link(scene, loose, a, other.body);
    addContact(w, level, scene, a, own, other, m);
  }
}

// One-way parts are solid to a body from every side.
OBBY_APART void meetParts(World& w, LooseBody* loose, const level::LevelView& level,
                          LooseScene& scene, int a) {
  Rigid& body = scene.bodies[a];
  const int32_t cell = cellOf<float>(level.looseGrid, body.position);
  if (cell < 0) return;
  const float margin = contactMargin(level.params, length(body.velocity));
  const float reach = level.loose[a].radius + margin;
  const Box near{body.position - Vec3{reach, reach, reach},
                 body.position + Vec3{reach, reach, reach}};
  const uint32_t* list = level.looseGrid.lists + level.looseGrid.cells[cell];
  for (uint32_t i = 1; i <= list[0]; ++i) {
    const level::Bounds& bounds = level.bounds[list[i]];
    if (!(bounds.flags & level::kSolid) || !overlaps(bounds.box(), near)) continue;
    const level::Collider& c = level.colliders[list[i]];
    const uint32_t flags = bounds.flags;
    Partner part{convexOf(c, c.pose), kPart, &c, flags, c.pose};
    if (flags & (kLeaves | level::kMoving | level::kConveyor)) body.restless = true;
    if ((flags & kLeaves) && isAway(w, level, c.role, flags)) continue;
    if (flags & level::kMoving) {
      part.convex.pose = poseOf(level.movers[c.mover], w, 1);
      part.before = poseOf(level.movers[c.mover], w, 0);
      if (!overlaps(boundsOf(part.convex.pose, c.shape.half), near)) continue;
    }
    meet(w, loose, level, scene, a, part, margin);
  }
}

OBBY_APART void meetBodies(World& w, LooseBody* loose, const level::LevelView& level,
                           LooseScene& scene, int a, uint32_t done) {
  for (int b = 0; b < int(level.looseCount); ++b) {
    const Rigid &one = scene.bodies[a], &other = scene.bodies[b];
    if (loose[b].state == LooseState::gone || (done >> b & 1)) continue;
    const float margin = contactMargin(level.params, length(one.velocity - other.velocity));
    const Vec3 d = other.position - one.position;
    const float reach = level.loose[a].radius + level.loose[b].radius + margin;
    if (dot(d, d) > reach * reach) continue;
    const level::Loose& l = level.loose[b];
    const Pose pose = poseOf(other, l);
    for (uint32_t i = 0; i < l.colliderCount; ++i) {
      const level::Collider& c = level.colliders[l.firstCollider + i];
      meet(w, loose, level, scene, a, {convexOf(c, pose), b, &c, 0, pose}, margin);
    }
  }
}

// Contacts of all bodies that are awake, and of those that they wake.
OBBY_DEVICE void findContacts(World& w, LooseBody* loose, const level::LevelView& level,
                              LooseScene& scene) {
  const int count = int(level.looseCount);
  scene.bodies[kPart] = {};
  scene.bodies[kPart].inverseInertia = {{}, {}, {}};
  for (int i = 0; i < count; ++i) {
    scene.bodies[i] = rigidOf(loose[i], level.loose[i]);
    scene.bodies[i].linked = 1u << i;
  }
  uint32_t done = 0;
  // A body that was woken by a later one has its turn in the next pass.
  for (bool more = true; more;) {
    more = false;
    for (int i = 0; i < count; ++i) {
      if (!scene.bodies[i].moves || (done >> i & 1)) continue;
      done |= 1u << i;
      more = true;
      meetParts(w, loose, level, scene, i);
      meetBodies(w, loose, level, scene, i, done);
    }
  }
}

}  // namespace obby::sim
