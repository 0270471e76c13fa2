// Rollouts in lockstep: runRollout() for each of them, with their ticks taken together in SIMD
// lanes. Host only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/simulator.h"
#include "solve/search/rollouts/explorer.h"

namespace obby::solve {

// The worlds of running rollouts are contiguous, since the group passes over them several times a
// tick. Their order has no meaning.
class RolloutGroup {
 public:
  explicit RolloutGroup(const ExploreContext& context) : context_(context) {}

  // Adds a rollout of at most `ticks` ticks. `bodies`: (level.bodyCount), advanced in place.
  void add(uint64_t seed, uint64_t rollout, const sim::World& start, sim::RigidBody* bodies,
           uint32_t ticks) {
    members_.push_back({Explorer(seed, rollout), members_.size(), ticks});
    worlds_.push_back(start);
    bodies_.push_back(bodies);
  }

  // The running rollouts, which are renumbered at every tick.
  size_t size() const { return members_.size(); }
  size_t index(size_t i) const { return members_[i].index; }  // in the order of add()
  const sim::World& world(size_t i) const { return worlds_[i]; }
  const sim::RigidBody* bodies(size_t i) const { return bodies_[i]; }

  // Advances every world to its end. look(t) is called after tick t = 1, 2, ... of all running
  // rollouts, and end(t, i) for those that took their last tick.
  template <class Look, class End>
  void run(Look&& look, End&& end) {
    for (sim::World& w : worlds_) pointers_.push_back(&w);
    actions_.resize(worlds_.size());
    for (uint32_t t = 1; size() > 0; ++t) {
      tick();
      look(t);
      for (size_t i = 0; i < size();) {
        if (goesOn(i, t)) {
          ++i;
        } else {
          end(t, i);
          remove(i);
        }
      }
    }
  }

 private:
  struct alignas(64) Member {
    Explorer explorer;
    size_t index;
    uint32_t ticks;
  };

  void tick() {
    for (size_t i = 0; i < size(); ++i)
      actions_[i] = members_[i].explorer.next(context_, worlds_[i], bodies_[i]);
    sim::advanceAll(context_.level, &context_.query, std::span(pointers_).first(size()),
                    bodies_.data(), actions_.data());
  }

  bool goesOn(size_t i, uint32_t t) const {
    const sim::World& w = worlds_[i];
    return t < members_[i].ticks && w.outcome == sim::Outcome::running && !doomed(context_, w);
  }

  void remove(size_t i) {
    members_[i] = members_.back();
    worlds_[i] = worlds_.back();
    bodies_[i] = bodies_.back();
    members_.pop_back();
    worlds_.pop_back();
    bodies_.pop_back();
  }

  const ExploreContext& context_;
  std::vector<Member> members_;
  std::vector<sim::World> worlds_;
  std::vector<sim::RigidBody*> bodies_;
  std::vector<sim::World*> pointers_;  // to worlds_
  std::vector<sim::Action> actions_;
};

}  // namespace obby::solve
