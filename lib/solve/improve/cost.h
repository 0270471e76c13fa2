// The cost of a trajectory, summed tick by tick, so that a search can stop a trajectory that is
// already dearer than the best one.
#pragma once

#include <vector>

#include "solve/improve/preference.h"
#include "solve/model/problem.h"

namespace obby::solve {

// The cost of a trajectory up to some tick.
struct CostState {
  double cost = 0;  // seconds
  uint32_t ticks = 0;
  sim::Action last{};  // of the last tick
  bool inAir = false;
  bool moved = false;  // `heading` is valid
  Turns heading = 0;   // direction of movement when it was last sampled
};

class CostMeter {
 public:
  // Looks for parts that kill within `space`, which should contain all trajectories with some
  // studs around. The problem must outlive the meter.
  CostMeter(const Problem& problem, const CostWeights& weights, const Box& space);

  // Adds a tick. `jumped`: a jump was made in it. `bodies`: (level.bodyCount) after the tick.
  void note(CostState& state, const sim::Action& action, bool jumped, const sim::World& after,
            const sim::RigidBody* bodies) const;

 private:
  double sampled(CostState& state, const sim::World& w, const sim::RigidBody* bodies) const;
  float nearHazard(const sim::World& w, const sim::RigidBody* bodies) const;
  // `reach`: studs from an edge at which it begins to count.
  float nearEdge(const sim::World& w, const sim::RigidBody* bodies, float reach) const;

  const Problem& problem_;
  CostWeights weights_;
  std::vector<uint32_t> hazards_;  // colliders
  double secondsPerTick_;
};

}  // namespace obby::solve
