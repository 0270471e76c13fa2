// Advances dynamic bodies that meet only parts by one tick, with a body in each lane. body_step.h
// does the same for the bodies of a world. Part of the wide tick (wide_tick.h); host only.
#pragma once

#include "sim/body_solver.h"
#include "simd/wide_list.h"

namespace obby::sim {

using WideContact = BodyContactT<WideFloat, 1>;

OBBY_LANES PairT<WideFloat> pairOf(const RigidT<WideFloat>& body, const WideContact& c) {
  return {{body.velocity, c.surface}, {body.spin, {}}, {body.inverseMass, 0.0f}};
}

class BodyLanes {
 public:
  static constexpr int kMaxContacts = 8;  // per body

  BodyLanes(const Params& params, const RigidT<WideFloat>& body) : p_(params), body_(body) {}

  // Adds a contact, in the order of the parts; at most kMaxContacts.
  void add(const WideContact& c) { contacts_[count_++] = c; }
  void run() {
    estimateLoads();
    for (int s = 0; s < p_.substeps; ++s) step(p_.substepSeconds);
    for (int round = 0; round < kBounceRounds; ++round) {
      forContacts([](Pair& pair, WideContact& c) { applyBounce<F, 1>(pair, c); });
    }
  }
  const RigidT<WideFloat>& body() const { return body_; }

 private:
  using F = WideFloat;
  using Pair = PairT<F>;

  template <class Work>
  OBBY_LANES void forContacts(Work&& work) {
    for (int k = 0; k < count_; ++k) {
      Pair pair = pairOf(body_, contacts_[k]);
      work(pair, contacts_[k]);
      body_.velocity = pair.velocity[0], body_.spin = pair.spin[0];
    }
  }

  void estimateLoads() {
    const auto holds = [](const WideContact& c) {
      return (c.count > 0) & holdsUp<F, 1>(c, c.normal.y < -kUpright);
    };
    WideInt supports = 0;
    for (int k = 0; k < count_; ++k) {
      supports = supports + select(holds(contacts_[k]), WideInt(1), WideInt(0));
    }
    const F load = p_.gravity * p_.substepSeconds / body_.inverseMass;
    for (int k = 0; k < count_; ++k) {
      bear<F, 1>(contacts_[k], load / toFloat(supports), holds(contacts_[k]));
    }
  }

  void step(float dt) {
    body_.velocity.y -= p_.gravity * dt;
    const Softness soft = softnessOf(dt);
    const float slop = 0.5f * p_.contactSkin;
    forContacts([](Pair& pair, WideContact& c) { warmStart<F, 1>(pair, c); });
    for (int round = 0; round < kRounds; ++round) {
      forContacts([&](Pair& pair, WideContact& c) {
        solveNormals<F, 1>(pair, c, soft, dt, slop);
        solveFriction<F, 1>(pair, c);
      });
    }
    move<F>(body_, p_, dt);
    for (int k = 0; k < count_; ++k) follow<F, 1>(pairOf(body_, contacts_[k]), contacts_[k], dt);
    forContacts([&](Pair& pair, WideContact& c) {
      solveNormals<F, 1>(pair, c, {0, 1, 0}, dt, slop);
    });
  }

  const Params& p_;
  RigidT<F> body_;
  int count_ = 0;
  union {  // leaves the array uninitialised
    WideContact contacts_[kMaxContacts];
  };
};

}  // namespace obby::sim
