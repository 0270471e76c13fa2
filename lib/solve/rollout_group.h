// Rollouts in step: the same as runRollout for each of them, with their ticks taken together in
// SIMD lanes. Host only.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/rules.h"
#include "sim/wide_tick.h"
#include "solve/explorer.h"

namespace obby::solve {

class RolloutGroup {
 public:
  explicit RolloutGroup(const ExploreContext& context) : context_(context) {}

  void add(uint64_t seed, uint64_t rollout, sim::World& world) {
    running_.push_back({Explorer(seed, rollout), &world, running_.size()});
  }

  // Advances every world by at most `ticks` ticks. visit(i, world) is called after each tick of the
  // i-th world that was added.
  template <class Visit>
  void run(uint32_t ticks, Visit&& visit) {
    for (uint32_t t = 0; t < ticks && !running_.empty(); ++t) {
      tick();
      size_t kept = 0;
      for (Member& m : running_) {
        sim::applyRules(*m.world, context_.level, context_.query);
        visit(m.index, *m.world);
        if (m.world->outcome != sim::Outcome::running) continue;
        if (&running_[kept] != &m) running_[kept] = m;
        ++kept;
      }
      running_.erase(running_.begin() + std::ptrdiff_t(kept), running_.end());
    }
  }

 private:
  struct Member {
    Explorer explorer;
    sim::World* world;
    size_t index;
  };

  void tick() {
    worlds_.clear();
    actions_.clear();
    for (Member& m : running_) {
      worlds_.push_back(m.world);
      actions_.push_back(m.explorer.next(context_, *m.world));
    }
    sim::tickAll(context_.level, worlds_.data(), actions_.data(), worlds_.size());
  }

  const ExploreContext& context_;
  std::vector<Member> running_;
  std::vector<sim::World*> worlds_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::solve
