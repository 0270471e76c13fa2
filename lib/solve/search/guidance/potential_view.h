// Scores how promising a state is for the search, apart from how often its cell was seen. For host
// and device.
#pragma once

#include "sim/next_region.h"
#include "sim/world.h"

namespace obby::solve {

// 1.5 d0 of each segment of a query, see potentialOf(). Plain span, for device code.
struct PotentialView {
  const float* spans = nullptr;  // (segments)
  uint32_t segments = 0;         // number of segments: one to each target and one to the goal
};

template <class Table>
OBBY_DEVICE void forTables(PotentialView& p, Table&& table) {
  table(p.spans, p.segments);
}

// Returns (1 + 4 max(0, 1 - d / (1.5 d0))) (1 + 3 targets). `targets` counts the waypoints and
// visits reached, and d is the distance to the next region. d0 is that distance at the start of the
// segment; with a choice of regions it is the farthest possible.
OBBY_DEVICE float potentialOf(const PotentialView& p, const level::QueryView& query,
                              const sim::World& world) {
  const uint32_t targets = targetsReached(world);
  const uint32_t segment = targets < p.segments ? targets : p.segments - 1;
  const float near = maxf(0.0f, 1.0f - nextRegion(query, world).distance / p.spans[segment]);
  return (1.0f + 4.0f * near) * (1.0f + 3.0f * float(segment));
}

}  // namespace obby::solve
