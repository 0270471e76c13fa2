// Worlds that advance one tick together, in SIMD lanes.
#pragma once

#include <vector>

#include "sim/simulator.h"
#include "solve/model/problem.h"

namespace obby::solve {

class Lockstep {
 public:
  // The problem must outlive this object.
  explicit Lockstep(const Problem& problem) : problem_(problem) {}

  // Adds a world to the next tick. `bodies`: (level.bodyCount). Both are advanced in place.
  void add(sim::World& world, std::vector<sim::RigidBody>& bodies, const sim::Action& action) {
    worlds_.push_back(&world);
    bodies_.push_back(bodies.data());
    actions_.push_back(action);
  }

  // Advances the added worlds, and forgets them.
  void advance() {
    sim::advanceAll(problem_.level, &problem_.query, worlds_, bodies_.data(), actions_.data());
    steps_ += worlds_.size();
    worlds_.clear();
    bodies_.clear();
    actions_.clear();
  }

  uint64_t steps() const { return steps_; }  // simulated ticks

 private:
  const Problem& problem_;
  uint64_t steps_ = 0;
  std::vector<sim::World*> worlds_;
  std::vector<sim::RigidBody*> bodies_;
  std::vector<sim::Action> actions_;
};

}  // namespace obby::solve
