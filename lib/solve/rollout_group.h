// Rollouts in step: the same as runRollout for each of them, with their ticks taken together in
// SIMD lanes. Host only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/simulator.h"
#include "solve/explorer.h"

namespace obby::solve {

class RolloutGroup {
 public:
  explicit RolloutGroup(const ExploreContext& context) : context_(context) {}

  // A rollout of at most `ticks` ticks.
  void add(uint64_t seed, uint64_t rollout, sim::World& world, sim::LooseBody* loose,
           uint32_t ticks) {
    running_.push_back({Explorer(seed, rollout), &world, loose, running_.size(), ticks});
  }

  struct Member {
    Explorer explorer;
    sim::World* world;
    sim::LooseBody* loose;  // null where the level has none
    size_t index;           // in the order of add()
    uint32_t ticks;
  };

  // Advances every world to its end. visit(t, members) is called after tick t = 1, 2, ... with all
  // that took it.
  template <class Visit>
  void run(Visit&& visit) {
    for (uint32_t t = 1; !running_.empty(); ++t) {
      tick();
      visit(t, std::span<const Member>(running_));
      std::erase_if(running_, [&](const Member& m) {
        return t >= m.ticks || m.world->outcome != sim::Outcome::running ||
               doomed(context_, *m.world);
      });
    }
  }

 private:
  void tick() {
    worlds_.clear();
    loose_.clear();
    actions_.clear();
    for (Member& m : running_) {
      worlds_.push_back(m.world);
      loose_.push_back(m.loose);
      actions_.push_back(m.explorer.next(context_, *m.world));
    }
    sim::advanceAll(context_.level, &context_.query, worlds_, loose_.data(), actions_.data());
  }

  const ExploreContext& context_;
  std::vector<Member> running_;
  std::vector<sim::World*> worlds_;
  std::vector<sim::LooseBody*> loose_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::solve
