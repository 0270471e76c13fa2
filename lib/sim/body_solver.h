// Impulses that separate dynamic bodies and hold them by friction: sequential impulses in substeps,
// with soft contacts (Catto, Solver2D, 2024). This is the work of one contact and of one body in a
// substep, for one world or lanes of worlds.
#pragma once

#include "sim/body_contact.h"

namespace obby::sim {

// Contacts act as overdamped springs, so that overlapping bodies part without being flung.
constexpr float kContactHertz = 60, kContactDamping = 10;
constexpr float kMaxPush = 12;     // studs/s at which overlapping bodies part
constexpr float kBounceSpeed = 4;  // studs/s; slower contacts do not bounce
constexpr float kMaxSpin = 60;     // rad/s
// Rounds over all contacts in a substep. With one round, even a single body slides 4 % less far.
constexpr int kRounds = 2;
// Rounds over bouncing contacts. Fewer rounds leave the points with different speeds, which makes a
// body spin.
constexpr int kBounceRounds = 4;
// Slower and closer contacts count as resting.
constexpr float kRestSpeed = 2;    // studs/s
constexpr float kRestGap = 0.05f;  // studs
constexpr float kUpright = 0.5f;   // min vertical component of a supporting normal

struct Softness {
  float bias, mass, impulse;
};

OBBY_DEVICE Softness softnessOf(float dt) {
  const float omega = 2 * kPi * minf(kContactHertz, 0.25f / dt);
  const float a1 = 2 * kContactDamping + dt * omega, a2 = dt * omega * a1, a3 = 1 / (1 + a2);
  return {omega / a1, a2 * a3, a3};
}

// Calls work(k, asked) for the contact's points. `asked` are the lanes that have the point.
template <class F, int kBodies, class Work>
OBBY_DEVICE void forPoints(const BodyContactT<F, kBodies>& c, Work&& work) {
  for (int k = 0; k < geom::kMaxPoints && any(c.count > k); ++k) work(k, c.count > k);
}

// Applies the last substep's impulses first, since this substep's are nearly the same.
template <class F, int kBodies>
OBBY_DEVICE void warmStart(PairT<F>& s, const BodyContactT<F, kBodies>& c) {
  forPoints(c, [&](int k, MaskOf<F> asked) OBBY_INLINED {
    pushApart(s, c.points[k].push, c.normal, c.points[k].push.impulse, asked);
  });
  const MaskOf<F> touches = c.count > 0;
  for (int t = 0; t < 2; ++t) pushApart(s, c.slide[t], c.tangents[t], c.slide[t].impulse, touches);
  pushApart(s, c.twist, {}, c.twist.impulse, touches);
}

// Changes the impulse of a point to `sum`.
template <class F, int kBodies>
OBBY_DEVICE void pressTo(PairT<F>& s, ContactPointT<F, kBodies>& p, Vec3T<F> normal, F sum,
                         MaskOf<F> asked) {
  pushApart(s, p.push, normal, sum - p.push.impulse, asked);
  p.push.impulse = select(asked, sum, p.push.impulse);
  p.max = select(asked, maxf(p.max, sum), p.max);
}

// Removes `speed`, which is negative, at all points at once. Solving the points one after another
// would make a body spin.
template <class F, int kBodies>
OBBY_DEVICE void pressAll(PairT<F>& s, BodyContactT<F, kBodies>& c, F speed, MaskOf<F> asked) {
  const F impulse = -c.press.mass * speed, share = impulse / toFloat(c.count);
  pushApart(s, c.press, c.normal, impulse, asked);
  for (ContactPointT<F, kBodies>& p : c.points) {
    p.push.impulse = select(asked, p.push.impulse + share, p.push.impulse);
    p.max = select(asked, maxf(p.max, p.push.impulse), p.max);
  }
}

template <class F, int kBodies>
OBBY_DEVICE void solveNormals(PairT<F>& s, BodyContactT<F, kBodies>& c, const Softness& soft,
                              float dt, float slop) {
  forPoints(c, [&](int k, MaskOf<F> asked) OBBY_INLINED {
    ContactPointT<F, kBodies>& p = c.points[k];
    const F distance = p.distance + slop;
    const MaskOf<F> apart = distance > 0.0f;
    F bias = 0.0f, mass = 1.0f, relax = 0.0f;
    if (soft.bias > 0) {
      bias = maxf(soft.bias * distance, F(-kMaxPush));
      mass = select(apart, F(1.0f), F(soft.mass));
      relax = select(apart, F(0.0f), F(soft.impulse));
    }
    if (any(apart)) bias = select(apart, distance / dt, bias);
    const F speed = speedOf(s, p.push, c.normal);
    const F wanted = -p.push.mass * mass * (speed + bias) - relax * p.push.impulse;
    pressTo(s, p, c.normal, maxf(p.push.impulse + wanted, F(0.0f)), asked);
  });
}

template <class F, int kBodies>
OBBY_DEVICE void solveFriction(PairT<F>& s, BodyContactT<F, kBodies>& c) {
  const MaskOf<F> asked = c.count > 0;
  F pressed = 0.0f;
  forPoints(c, [&](int k, MaskOf<F> has) OBBY_INLINED {
    pressed = select(has, pressed + c.points[k].push.impulse, pressed);
  });
  const F max = c.friction * pressed;
  F wanted[2];
  for (int t = 0; t < 2; ++t) {
    const PushT<F, kBodies>& p = c.slide[t];
    wanted[t] = p.impulse - p.mass * speedOf(s, p, c.tangents[t]);
  }
  const F size = sqrtf32(wanted[0] * wanted[0] + wanted[1] * wanted[1]);
  const F scale = select(size > max, max / size, F(1.0f));
  for (int t = 0; t < 2; ++t) {
    PushT<F, kBodies>& p = c.slide[t];
    pushApart(s, p, c.tangents[t], wanted[t] * scale - p.impulse, asked);
    p.impulse = wanted[t] * scale;
  }
  const F min = max * c.twistRadius;
  const F turning = speedOf(s, c.twist, {});
  const F sum = clampf(c.twist.impulse - c.twist.mass * turning, -min, min);
  pushApart(s, c.twist, {}, sum - c.twist.impulse, asked);
  c.twist.impulse = sum;
}

template <class F, int kBodies>
OBBY_DEVICE void bounceAll(PairT<F>& s, BodyContactT<F, kBodies>& c) {
  F approach = 0.0f;
  MaskOf<F> asked = (c.count > 0) & (c.bounce > 0.0f);
  forPoints(c, [&](int k, MaskOf<F> has) OBBY_INLINED {
    const ContactPointT<F, kBodies>& p = c.points[k];
    approach = select(has, approach + p.approach, approach);
    asked = asked & (((p.approach <= -kBounceSpeed) & (p.max > 0.0f)) | !has);
  });
  if (!any(asked)) return;
  const F speed = speedOf(s, c.press, c.normal) + c.bounce * (approach / toFloat(c.count));
  asked = asked & (speed < 0.0f);
  if (any(asked)) pressAll(s, c, speed, asked);
}

template <class F, int kBodies>
OBBY_DEVICE void applyBounce(PairT<F>& s, BodyContactT<F, kBodies>& c) {
  bounceAll(s, c);
  forPoints(c, [&](int k, MaskOf<F> has) OBBY_INLINED {
    ContactPointT<F, kBodies>& p = c.points[k];
    const MaskOf<F> asked =
        has & (c.bounce > 0.0f) & (p.approach <= -kBounceSpeed) & (p.max > 0.0f);
    if (!any(asked)) return;
    const F speed = speedOf(s, p.push, c.normal) + c.bounce * p.approach;
    pressTo(s, p, c.normal, maxf(p.push.impulse - p.push.mass * speed, F(0.0f)), asked);
  });
}

template <class F>
OBBY_DEVICE Vec3T<F> limited(Vec3T<F> v, float max) {
  const F size = length(v);
  return select(size > max, v * (max / size), v);
}

template <class F>
OBBY_DEVICE void move(RigidT<F>& b, const Params& p, float dt) {
  b.velocity = limited(b.velocity, p.maxFallSpeed);
  b.spin = limited(b.spin, kMaxSpin);
  b.position += b.velocity * F(dt);
  b.rotation = turned(b.rotation, b.spin * F(dt));
  b.axes = toMat3(b.rotation);
}

// Returns the ticks that a body has been slow, this one included. `restless` is true if its support
// may go away, or if it has none, as at the top of a throw.
template <class F>
OBBY_DEVICE IntOf<F> stillTicksOf(const RigidT<F>& b, F radius, MaskOf<F> restless, IntOf<F> before,
                                  const Params& p) {
  const MaskOf<F> slow =
      (length(b.velocity) < p.sleepSpeed) & (length(b.spin) * radius < p.sleepSpeed) & !restless;
  const IntOf<F> more = select(before < 0xffff, before + 1, IntOf<F>(0xffff));
  return select(slow, more, IntOf<F>(0));
}

// Updates the gaps after the bodies have moved.
template <class F, int kBodies>
OBBY_DEVICE void follow(const PairT<F>& s, BodyContactT<F, kBodies>& c, float dt) {
  const F belt = dot(c.surface, c.normal) - c.comes;  // a conveyor moves, its part does not
  forPoints(c, [&](int k, MaskOf<F>) OBBY_INLINED {
    c.points[k].distance += dt * (speedOf(s, c.points[k].push, c.normal) - belt);
  });
}

// Returns true if the contact supports a resting body. `isUpper` is true if the body is above.
template <class F, int kBodies>
OBBY_DEVICE MaskOf<F> holdsUp(const BodyContactT<F, kBodies>& c, MaskOf<F> isUpper) {
  F slowest = 1e30f, nearest = 1e30f;
  forPoints(c, [&](int k, MaskOf<F> has) OBBY_INLINED {
    slowest = select(has, minf(slowest, absf(c.points[k].approach)), slowest);
    nearest = select(has, minf(nearest, c.points[k].distance), nearest);
  });
  return isUpper & (slowest < kRestSpeed) & (nearest < kRestGap);
}

// Gives a contact its share of the load that it will bear. Impulses are not kept between ticks, and
// high stacks stand because of this first estimate.
template <class F, int kBodies>
OBBY_DEVICE void bear(BodyContactT<F, kBodies>& c, F share, MaskOf<F> asked) {
  const F each = share / toFloat(c.count);
  for (ContactPointT<F, kBodies>& p : c.points) {
    p.push.impulse = select(asked, each, p.push.impulse);
  }
}

}  // namespace obby::sim
