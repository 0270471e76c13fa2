// Regenerates a trajectory from the archive by replaying the chain of rollouts that led to it.
#pragma once

#include <cstdint>

#include "solve/model/problem.h"
#include "solve/model/trajectory.h"
#include "solve/search/archive/archive.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

// Returns the trajectory that ends `end.ticks` ticks into rollout `end.rollout` from node
// `end.parent`.
Trajectory regenerate(const ExploreContext& context, uint64_t seed, const Problem& problem,
                      const ChunkedVector<Node>& nodes, const Node& end);

}  // namespace obby::solve
