// A contact of a dynamic body, for one world or lanes of worlds: the lines along which it pushes
// its bodies, and their response.
#pragma once

#include "geom/ring.h"
#include "sim/rigid_body.h"

namespace obby::sim {

// A body during the tick.
template <class F>
struct RigidT {
  Vec3T<F> position, velocity, spin;
  QuatT<F> rotation;
  Mat3T<F> axes;            // axes of the part
  Mat3T<F> inverseInertia;  // world
  F inverseMass;
};

template <class F>
OBBY_DEVICE RigidT<F> rigidOf(Vec3T<F> position, Vec3T<F> velocity, Vec3T<F> spin,
                              QuatT<F> rotation, const Mat3T<F>& inverseInertia, F inverseMass) {
  const Mat3T<F> axes = toMat3(rotation), own = axes * inverseInertia;
  // Computes axes * inverse * transpose(axes), by rows of the transpose.
  const Vec3T<F> rows[3] = {{axes.x.x, axes.y.x, axes.z.x},
                            {axes.x.y, axes.y.y, axes.z.y},
                            {axes.x.z, axes.y.z, axes.z.z}};
  return {position,   velocity, spin, rotation, axes, {own * rows[0], own * rows[1], own * rows[2]},
          inverseMass};
}

// One line along which a contact pushes its bodies apart: a direction through a point, or a
// rotation about a direction. With kBodies 1 the other side is a part, which nothing moves.
template <class F, int kBodies>
struct PushT {
  Vec3T<F> turn[kBodies];    // speed along the line per unit of spin
  Vec3T<F> answer[kBodies];  // spin per unit of impulse
  F mass;                    // effective mass
  F impulse;                 // impulse of the last substep
};

template <class F, int kBodies>
struct ContactPointT {
  PushT<F, kBodies> push;  // along the normal
  F distance;              // present gap, studs
  F max;                   // max impulse so far
  F approach;              // speed at the start of the tick; negative when approaching
};

// A contact of a body with a part or with a second body. The normal points away from the first
// body.
template <class F, int kBodies>
struct BodyContactT {
  Vec3T<F> surface;  // velocity of the part's surface at the contact
  F comes;           // speed of the part itself along the normal; negative toward the body
  Vec3T<F> normal;
  F friction, bounce;
  IntOf<F> count;
  ContactPointT<F, kBodies> points[geom::kMaxPoints];
  // Friction acts at the middle of the points, along two tangents and about the normal.
  Vec3T<F> tangents[2];
  PushT<F, kBodies> slide[2], twist;
  PushT<F, kBodies> press;  // all points at once, along the normal at their middle
  F twistRadius;
};

// Velocities of a contact's bodies while it is solved. These are copies, which stay in registers.
template <class F>
struct PairT {
  Vec3T<F> velocity[2], spin[2];  // a part has its surface's velocity, and no spin
  F inverseMass[2];
};

// Returns the speed of the second surface away from the first along the line. `along` is zero for a
// rotation.
template <class F, int kBodies>
OBBY_DEVICE F speedOf(const PairT<F>& s, const PushT<F, kBodies>& p, Vec3T<F> along) {
  F turning = 0.0f;
  if constexpr (kBodies == 2) turning = dot(p.turn[1], s.spin[1]);
  return dot(along, s.velocity[1] - s.velocity[0]) + (turning - dot(p.turn[0], s.spin[0]));
}

// Applies an impulse along the line in the lanes of `asked`. A part does not respond.
template <class F, int kBodies>
OBBY_DEVICE void pushApart(PairT<F>& s, const PushT<F, kBodies>& p, Vec3T<F> along, F impulse,
                           MaskOf<F> asked) {
  const auto keep = [asked](Vec3T<F>& old, Vec3T<F> now) { old = select(asked, now, old); };
  keep(s.velocity[0], s.velocity[0] - along * (impulse * s.inverseMass[0]));
  keep(s.spin[0], s.spin[0] - p.answer[0] * impulse);
  if constexpr (kBodies == 2) {
    keep(s.velocity[1], s.velocity[1] + along * (impulse * s.inverseMass[1]));
    keep(s.spin[1], s.spin[1] + p.answer[1] * impulse);
  }
}

// Returns a push with these `turns` (PushT::turn). `inverseMass` is 0 for a pure rotation.
template <class F, int kBodies>
OBBY_DEVICE PushT<F, kBodies> pushAlong(const RigidT<F>* const (&bodies)[kBodies],
                                        const Vec3T<F> (&turns)[kBodies], F inverseMass) {
  PushT<F, kBodies> p;
  F yield = inverseMass;
  for (int i = 0; i < kBodies; ++i) {
    p.turn[i] = turns[i];
    p.answer[i] = bodies[i]->inverseInertia * turns[i];
    yield = yield + dot(turns[i], p.answer[i]);
  }
  p.mass = select(yield > 0.0f, 1.0f / yield, F(0.0f));
  p.impulse = 0.0f;
  return p;
}

// Returns the mean of the points.
template <class F>
OBBY_DEVICE Vec3T<F> middleOf(const geom::ManifoldT<F>& m) {
  Vec3T<F> sum{};
  for (int i = 0; i < geom::kMaxPoints && any(m.count > i); ++i) {
    sum = select(m.count > i, sum + m.points[i].position, sum);
  }
  return sum * (1.0f / toFloat(m.count));
}

// Computes the solver's data of a contact whose surface, normal and materials are set.
template <class F, int kBodies>
OBBY_DEVICE void prepare(BodyContactT<F, kBodies>& c, const RigidT<F>* const (&bodies)[kBodies],
                         const PairT<F>& pair, const geom::ManifoldT<F>& m, Vec3T<F> middle,
                         float tickSeconds) {
  F inverseMass = pair.inverseMass[0];
  if constexpr (kBodies == 2) inverseMass = inverseMass + pair.inverseMass[1];
  const auto line = [&](auto&& turnOf, F mass) {
    Vec3T<F> turns[kBodies];
    for (int i = 0; i < kBodies; ++i) turns[i] = turnOf(*bodies[i]);
    if constexpr (kBodies == 2) {
      if (!(pair.inverseMass[1] > 0)) turns[1] = {};  // a part does not turn
    }
    return pushAlong<F, kBodies>(bodies, turns, mass);
  };
  const auto through = [&](Vec3T<F> at, Vec3T<F> n) {
    return line([&](const RigidT<F>& body) { return cross(at - body.position, n); }, inverseMass);
  };
  c.count = m.count;
  F spread = 0.0f;
  for (int i = 0; i < geom::kMaxPoints && any(m.count > i); ++i) {
    ContactPointT<F, kBodies>& p = c.points[i];
    const Vec3T<F> at = m.points[i].position;
    p.push = through(at, c.normal);
    // The manifold has moving parts at the tick's end; this is the gap at its start.
    p.distance = m.points[i].distance - c.comes * tickSeconds;
    p.max = 0.0f;
    p.approach = speedOf(pair, p.push, c.normal);
    spread = select(m.count > i, spread + length(at - middle), spread);
  }
  geom::tangentsOf<F>(c.normal, c.tangents[0], c.tangents[1]);
  for (int t = 0; t < 2; ++t) c.slide[t] = through(middle, c.tangents[t]);
  c.press = through(middle, c.normal);
  c.twist = line([&](const RigidT<F>&) { return c.normal; }, F(0.0f));
  c.twistRadius = spread / toFloat(m.count);
}

}  // namespace obby::sim
