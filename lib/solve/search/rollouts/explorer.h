// The actions of a rollout: a sequence of macros, each aimed or random, drawn from the rollout's
// own stream of random numbers. The same (seed, stream, start) gives the same actions.
#pragma once

#include "solve/search/archive/archive_node.h"
#include "solve/search/rollouts/macro_aim.h"
#include "solve/search/rollouts/macro_random.h"
#if defined(__CUDACC__)
#include "policy/decide.h"
#endif

namespace obby::solve {

#if defined(__CUDACC__)
OBBY_DEVICE sim::Action moveOfPolicy(const ExploreContext& c, const sim::World& w,
                                     const sim::RigidBody* bodies, Random* random) {
  const policy::Scene scene{c.level, c.query, c.pilot.surroundings};
  return policy::decide<float>(scene, c.pilot.network, w, bodies, random);
}
#else
// Returns the policy's action for the next kSteerEvery ticks, computed in SIMD lanes. `random`:
// null for the likeliest move.
sim::Action moveOfPolicy(const ExploreContext& c, const sim::World& w, const sim::RigidBody* bodies,
                         Random* random);
#endif

class Explorer {
 public:
  OBBY_DEVICE Explorer(uint64_t seed, uint64_t stream)
      : kind_((stream & kByPolicy) != 0 ? Kind::policy : Kind::none),
        likeliest_((stream & kLikeliest) != 0),
        random_(seed, stream) {}

  // `bodies`: (level.bodyCount).
  OBBY_DEVICE sim::Action next(const ExploreContext& c, const sim::World& w,
                               const sim::RigidBody* bodies) {
    const bool plans = tick_ == 0;  // all rollouts plan at the same ticks: lanes and groups agree
    tick_ = tick_ + 1 == kSteerEvery ? 0 : tick_ + 1;
    if (plans && kind_ == Kind::policy) {
      held_.action = moveOfPolicy(c, w, bodies, likeliest_ ? nullptr : &random_);
    }
    if (plans && kind_ == Kind::aim && !planAimMacro(c, w, aim_)) kind_ = Kind::none;
    if (kind_ == Kind::none) draw(c, w);
    // All kinds are computed without a branch, since the kind is unpredictable.
    const bool aims = kind_ == Kind::aim;
    sim::Action action = aims ? aim_.action : held_.action;
    action.jump = aims ? jumpsNow(w, aim_) : held_.action.jump;
    held_.ticks -= aims ? 0 : 1;
    kind_ = aims || held_.ticks != 0 ? kind_ : Kind::none;
    // A jump beyond the limit would end the attempt.
    if (c.jumpsLimited && action.jump && jumpsLeft(c.query, w) == 0) action.jump = false;
    return action;
  }

 private:
  enum class Kind : uint8_t { none, held, aim, policy };

  OBBY_DEVICE void draw(const ExploreContext& c, const sim::World& w) {
    if (c.settings.aimShare > 0 && random_.unit() < c.settings.aimShare &&
        drawAimMacro(c, w, random_, aim_)) {
      steer(c, w, grounded(w), aim_);
      kind_ = Kind::aim;
      return;
    }
    held_ = drawRandomMacro(random_);
    kind_ = Kind::held;
  }

  // Members that every tick reads come first.
  Kind kind_;
  uint8_t tick_ = 0;  // ticks since the last plan
  bool likeliest_;
  RandomMacro held_{};  // its `ticks` never run out under a policy
  AimMacro aim_{};
  Random random_;
};

}  // namespace obby::solve
