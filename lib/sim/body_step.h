// Advances the bodies of a world by a substep: all contacts, in the order in which they were found.
#pragma once

#include "sim/body_contacts.h"
#include "sim/body_solver.h"

namespace obby::sim {

// Returns true if `c` supports body `i` at rest. Sets `other` to the body or part that it stands
// on.
OBBY_DEVICE bool holdsUp(const BodyContact& c, int i, int& other) {
  other = c.a == i ? c.b : c.a;
  return holdsUp<float, 2>(
      c, (c.a == i && c.normal.y < -kUpright) || (c.b == i && c.normal.y > kUpright));
}

// Estimates the loads that the contacts of a stack will bear. Each body's weight, and the load on
// it, is handed down in equal shares, from the highest body to the lowest.
OBBY_APART void estimateLoads(BodyScene& s, int count, const Params& p, float dt) {
  int order[level::kMaxBodies], moving = 0;
  float load[level::kMaxBodies];
  for (int i = 0; i < count; ++i) {
    if (!s.bodies[i].moves) continue;
    load[i] = p.gravity * dt / s.bodies[i].inverseMass;
    int k = moving++;
    for (; k > 0 && s.bodies[order[k - 1]].position.y < s.bodies[i].position.y; --k) {
      order[k] = order[k - 1];
    }
    order[k] = i;
  }
  for (int n = 0; n < moving; ++n) {
    const int i = order[n];
    int supports = 0, below = 0;
    for (int k = 0; k < s.contactCount; ++k) supports += holdsUp(s.contacts[k], i, below);
    for (int k = 0; k < s.contactCount && supports > 0; ++k) {
      BodyContact& c = s.contacts[k];
      if (!holdsUp(c, i, below)) continue;
      const float share = load[i] / float(supports);
      bear<float, 2>(c, share, true);
      if (below != kPart) load[below] += share;
    }
  }
}

template <class Work>
OBBY_DEVICE void forContacts(BodyScene& s, Work&& work) {
  for (int i = 0; i < s.contactCount; ++i) {
    Pair pair = pairOf(s, s.contacts[i]);
    work(pair, s.contacts[i]);
    putPair(s, s.contacts[i], pair);
  }
}

OBBY_DEVICE void bounce(BodyScene& scene) {
  for (int round = 0; round < kBounceRounds; ++round) {
    forContacts(scene, [](Pair& pair, BodyContact& c) { applyBounce<float, 2>(pair, c); });
  }
}

// Advances all moving bodies by one substep.
OBBY_APART void stepBodies(BodyScene& s, int count, const Params& p, float dt) {
  for (int i = 0; i < count; ++i) {
    if (s.bodies[i].moves) s.bodies[i].velocity.y -= p.gravity * dt;
  }
  const Softness soft = softnessOf(dt);
  const float slop = 0.5f * p.contactSkin;
  forContacts(s, [](Pair& pair, BodyContact& c) { warmStart<float, 2>(pair, c); });
  for (int round = 0; round < kRounds; ++round) {
    forContacts(s, [&](Pair& pair, BodyContact& c) {
      solveNormals<float, 2>(pair, c, soft, dt, slop);
      solveFriction<float, 2>(pair, c);
    });
  }
  for (int i = 0; i < count; ++i) {
    if (s.bodies[i].moves) move<float>(s.bodies[i], p, dt);
  }
  for (int i = 0; i < s.contactCount; ++i) {
    follow<float, 2>(pairOf(s, s.contacts[i]), s.contacts[i], dt);
  }
  // Removes the speed that only served to separate overlapping bodies.
  forContacts(s, [&](Pair& pair, BodyContact& c) {
    solveNormals<float, 2>(pair, c, {0, 1, 0}, dt, slop);
  });
}

}  // namespace obby::sim
