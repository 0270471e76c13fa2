// A trajectory found by the search, as plain actions. It is regenerated from the archive by
// replaying the chain of rollouts that led to it.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/simulator.h"
#include "solve/archive/archive.h"
#include "solve/query/problem.h"
#include "solve/rollouts/explore_context.h"

namespace obby::solve {

constexpr uint32_t kPathStep = 6;  // ticks between the points of a path

struct Playthrough {
  std::vector<sim::ActionRun> actions;
  std::vector<Vec3> path;           // feet every kPathStep ticks, the start first
  std::vector<uint32_t> jumpTicks;  // ticks since the start
  sim::World end;
  std::vector<sim::LooseBody> endLoose;
  uint32_t ticks = 0;
};

// Returns the trajectory that ends `end.ticks` ticks into rollout `end.rollout` from node
// `end.parent`.
Playthrough regenerate(const ExploreContext& context, uint64_t seed, const Problem& problem,
                       const ChunkedVector<Node>& nodes, const Node& end);

}  // namespace obby::solve
