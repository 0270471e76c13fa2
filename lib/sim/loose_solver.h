// Impulses that keep loose bodies apart and hold them by friction: sequential impulses in substeps,
// with soft contacts (Catto, Solver2D, 2024). Everything is in a fixed order.
#pragma once

#include "sim/loose_contacts.h"

namespace obby::sim {

// Contacts act as critically overdamped springs, so that what overlaps parts without being flung.
constexpr float kContactHertz = 60, kContactDamping = 10;
constexpr float kMostPush = 12;    // studs/s: how fast overlapping bodies part
constexpr float kBounceSpeed = 4;  // studs/s: below this nothing bounces
constexpr float kMostSpin = 60;    // rad/s
constexpr int kIterations = 2;     // a substep
// Contacts slower and closer than these are taken to be at rest.
constexpr float kRestSpeed = 2;    // studs/s
constexpr float kRestGap = 0.05f;  // studs

struct Softness {
  float bias, mass, impulse;
};

OBBY_DEVICE Softness softnessOf(float dt) {
  const float omega = 2 * kPi * minf(kContactHertz, 0.25f / dt);
  const float a1 = 2 * kContactDamping + dt * omega, a2 = dt * omega * a1, a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

// What resists an impulse along `n` at `at` from the centre.
OBBY_DEVICE float yield(const Rigid& b, Vec3 at, Vec3 n) {
  const Vec3 turn = cross(at, n);
  return b.inverseMass + dot(turn, b.inverseInertia * turn);
}

OBBY_DEVICE void push(Rigid& b, Vec3 at, Vec3 impulse) {
  b.velocity += impulse * b.inverseMass;
  b.spin += b.inverseInertia * cross(at, impulse);
}

OBBY_DEVICE Vec3 velocityAt(const Rigid& b, Vec3 at) { return b.velocity + cross(b.spin, at); }

// Gives the impulses of the last substep at once: they are nearly those of this one.
OBBY_DEVICE void warmStart(Pair& s, const LooseContact& c) {
  for (int i = 0; i < c.count; ++i) {
    pushApart(s, c.points[i].push, c.normal, c.points[i].push.impulse);
  }
  for (int t = 0; t < 2; ++t) pushApart(s, c.slide[t], c.tangents[t], c.slide[t].impulse);
  pushApart(s, c.twist, {}, c.twist.impulse);
}

OBBY_DEVICE void solveNormals(Pair& s, LooseContact& c, const Softness& soft, float dt,
                              float slop) {
  for (int i = 0; i < c.count; ++i) {
    ContactPoint& p = c.points[i];
    const float distance = p.distance + slop;
    float bias = 0, mass = 1, relax = 0;
    if (distance > 0) {
      bias = distance / dt;
    } else if (soft.bias > 0) {
      bias = maxf(soft.bias * distance, -kMostPush);
      mass = soft.mass, relax = soft.impulse;
    }
    const float speed = speedOf(s, p.push, c.normal);
    const float wanted = -p.push.mass * mass * (speed + bias) - relax * p.push.impulse;
    const float sum = maxf(p.push.impulse + wanted, 0.0f);
    pushApart(s, p.push, c.normal, sum - p.push.impulse);
    p.push.impulse = sum;
    p.most = maxf(p.most, sum);
  }
}

OBBY_DEVICE void solveFriction(Pair& s, LooseContact& c) {
  float pressed = 0;
  for (int i = 0; i < c.count; ++i) pressed += c.points[i].push.impulse;
  const float most = c.friction * pressed;
  float wanted[2];
  for (int t = 0; t < 2; ++t) {
    const Push& p = c.slide[t];
    wanted[t] = p.impulse - p.mass * speedOf(s, p, c.tangents[t]);
  }
  const float size = sqrtf32(wanted[0] * wanted[0] + wanted[1] * wanted[1]);
  const float scale = size > most ? most / size : 1.0f;
  for (int t = 0; t < 2; ++t) {
    Push& p = c.slide[t];
    pushApart(s, p, c.tangents[t], wanted[t] * scale - p.impulse);
    p.impulse = wanted[t] * scale;
  }
  const float least = most * c.twistRadius;
  const float turning = speedOf(s, c.twist, {});
  const float sum = clampf(c.twist.impulse - c.twist.mass * turning, -least, least);
  pushApart(s, c.twist, {}, sum - c.twist.impulse);
  c.twist.impulse = sum;
}

OBBY_DEVICE void applyBounce(LooseScene& scene, LooseContact& c) {
  if (c.bounce <= 0) return;
  Pair s = pairOf(scene, c);
  for (int i = 0; i < c.count; ++i) {
    ContactPoint& p = c.points[i];
    if (p.approach > -kBounceSpeed || p.most <= 0) continue;
    const float speed = speedOf(s, p.push, c.normal) + c.bounce * p.approach;
    const float sum = maxf(p.push.impulse - p.push.mass * speed, 0.0f);
    pushApart(s, p.push, c.normal, sum - p.push.impulse);
    p.push.impulse = sum;
    p.most = maxf(p.most, sum);
  }
  putPair(scene, c, s);
}

OBBY_DEVICE Vec3 limited(Vec3 v, float most) {
  const float size = length(v);
  return size > most ? v * (most / size) : v;
}

OBBY_DEVICE void moveBodies(LooseScene& s, int count, const Params& p, float dt) {
  for (int i = 0; i < count; ++i) {
    Rigid& b = s.bodies[i];
    if (!b.moves) continue;
    b.velocity = limited(b.velocity, p.maxFallSpeed);
    b.spin = limited(b.spin, kMostSpin);
    b.position += b.velocity * dt;
    b.rotation = turned(b.rotation, b.spin * dt);
    b.axes = toMat3(b.rotation);
  }
  for (int i = 0; i < s.contactCount; ++i) {
    LooseContact& c = s.contacts[i];
    const Pair pair = pairOf(s, c);
    const float belt = dot(c.surface, c.normal) - c.comes;  // a conveyor moves, its part does not
    for (int k = 0; k < c.count; ++k) {
      c.points[k].distance += dt * (speedOf(pair, c.points[k].push, c.normal) - belt);
    }
  }
}

// Does `c` hold body `i` up, at rest? `other` is what it stands on.
OBBY_DEVICE bool holdsUp(const LooseContact& c, int i, int& other) {
  const bool isUpper = (c.a == i && c.normal.y < -0.5f) || (c.b == i && c.normal.y > 0.5f);
  other = c.a == i ? c.b : c.a;
  float slowest = 1e30f, nearest = 1e30f;
  for (int k = 0; k < c.count; ++k) {
    slowest = minf(slowest, absf(c.points[k].approach));
    nearest = minf(nearest, c.points[k].distance);
  }
  return isUpper && slowest < kRestSpeed && nearest < kRestGap;
}

// What the contacts of a stack will have to bear: each body's weight and what stands on it, handed
// down from the highest body to the lowest, in equal shares. Impulses are not kept between ticks;
// this is what makes high stacks stand all the same.
OBBY_APART void estimateLoads(LooseScene& s, int count, const Params& p, float dt) {
  int order[level::kMaxLoose];
  float load[level::kMaxLoose];
  for (int i = 0; i < count; ++i) {
    load[i] = s.bodies[i].moves ? p.gravity * dt / s.bodies[i].inverseMass : 0.0f;
    int k = i;
    for (; k > 0 && s.bodies[order[k - 1]].position.y < s.bodies[i].position.y; --k) {
      order[k] = order[k - 1];
    }
    order[k] = i;
  }
  for (int n = 0; n < count; ++n) {
    const int i = order[n];
    int supports = 0, below = 0;
    for (int k = 0; k < s.contactCount; ++k) supports += holdsUp(s.contacts[k], i, below);
    for (int k = 0; k < s.contactCount && supports > 0; ++k) {
      LooseContact& c = s.contacts[k];
      if (!holdsUp(c, i, below)) continue;
      const float share = load[i] / float(supports);
      for (int j = 0; j < c.count; ++j) c.points[j].push.impulse = share / float(c.count);
      if (below != kPart) load[below] += share;
    }
  }
}

// One substep of all bodies that move.
OBBY_APART void stepBodies(LooseScene& s, int count, const Params& p, float dt) {
  for (int i = 0; i < count; ++i) {
    if (s.bodies[i].moves) s.bodies[i].velocity.y -= p.gravity * dt;
  }
  const Softness soft = softnessOf(dt);
  const float slop = 0.5f * p.contactSkin;
  const auto forContacts = [&s](auto&& work) {
    for (int i = 0; i < s.contactCount; ++i) {
      Pair pair = pairOf(s, s.contacts[i]);
      work(pair, s.contacts[i]);
      putPair(s, s.contacts[i], pair);
    }
  };
  forContacts([](Pair& pair, LooseContact& c) { warmStart(pair, c); });
  for (int round = 0; round < kIterations; ++round) {
    forContacts([&](Pair& pair, LooseContact& c) {
      solveNormals(pair, c, soft, dt, slop);
      solveFriction(pair, c);
    });
  }
  moveBodies(s, count, p, dt);
  // Takes the speed back that only parted what overlapped.
  forContacts([&](Pair& pair, LooseContact& c) { solveNormals(pair, c, {0, 1, 0}, dt, slop); });
}

}  // namespace obby::sim
