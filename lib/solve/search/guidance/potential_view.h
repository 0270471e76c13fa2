// How promising a state is for the search, apart from how often its like was seen. For host and
// device.
#pragma once

#include "sim/next_region.h"
#include "sim/world.h"

namespace obby::solve {

// Of each leg of a query, 1.5 d0. Plain span, for device code.
struct PotentialView {
  const float* spans = nullptr;  // (legs)
  uint32_t legs = 0;             // targets and the goal
};

template <class Table>
OBBY_DEVICE void forTables(PotentialView& p, Table&& table) {
  table(p.spans, p.legs);
}

// How promising a state is, whatever its count: (1 + 4 max(0, 1 - d / (1.5 d0))) (1 + 3 targets),
// targets the waypoints and visits behind, d the distance to the next region, d0 what it was when
// that became the next; with a choice of regions, the farthest that it can have been.
OBBY_DEVICE float potentialOf(const PotentialView& p, const level::QueryView& query,
                              const sim::World& world) {
  const uint32_t targets = targetsReached(world);
  const uint32_t leg = targets < p.legs ? targets : p.legs - 1;
  const float near = maxf(0.0f, 1.0f - nextRegion(query, world).distance / p.spans[leg]);
  return (1.0f + 4.0f * near) * (1.0f + 3.0f * float(leg));
}

}  // namespace obby::solve
