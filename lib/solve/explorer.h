// What a rollout does next: a sequence of macros, each aimed or random, drawn from the rollout's
// own stream of random numbers. The same (seed, stream, start) gives the same actions.
#pragma once

#include "solve/macro_aim.h"
#include "solve/macro_random.h"

namespace obby::solve {

class Explorer {
 public:
  OBBY_DEVICE Explorer(uint64_t seed, uint64_t stream) : random_(seed, stream) {}

  OBBY_DEVICE sim::Action next(const ExploreContext& c, const sim::World& w) {
    if (kind_ == Kind::none) draw(c, w);
    sim::Action action;
    if (kind_ == Kind::aim) {
      bool done = false;
      action = stepAimMacro(c, w, aim_, done);
      if (done) kind_ = Kind::none;
    } else {
      action = held_.action;
      if (--held_.ticks == 0) kind_ = Kind::none;
    }
    // A jump beyond the limit would end the attempt.
    if (c.jumpsLimited && action.jump && jumpsLeft(c.query, w) == 0) action.jump = false;
    return action;
  }

 private:
  enum class Kind : uint8_t { none, held, aim };

  OBBY_DEVICE void draw(const ExploreContext& c, const sim::World& w) {
    if (c.settings.aimShare > 0 && random_.unit() < c.settings.aimShare &&
        drawAimMacro(c, w, random_, aim_)) {
      kind_ = Kind::aim;
      return;
    }
    held_ = drawRandomMacro(random_);
    kind_ = Kind::held;
  }

  Random random_;
  Kind kind_ = Kind::none;
  RandomMacro held_{};
  AimMacro aim_{};
};

}  // namespace obby::solve
