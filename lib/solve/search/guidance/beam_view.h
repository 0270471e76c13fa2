// The beam's rank of a state, lower is better: f = ticks so far + kBeamGreed * min ticks left + a
// penalty for earlier tries from the cell. For host and device.
#pragma once

#include "sim/next_region.h"
#include "sim/world.h"

namespace obby::solve {

constexpr uint32_t kBeamTries = 4;    // rollouts per cell and round
constexpr float kBeamGreed = 5;       // above 1: finds a solution sooner, but not the shortest
constexpr uint32_t kTriedTicks = 60;  // added to f by each round's tries, so no cell starves

// Plain spans, for device code.
struct BeamView {
  const float* segments = nullptr;  // (waypoints + 1), studs from each waypoint to the goal
  const float* hops = nullptr;  // (visits), studs from a visit to the nearest other or to the goal
  uint32_t segmentCount = 0, hopCount = 0;
  float ticksPerStud = 0;
};

template <class Table>
OBBY_DEVICE void forTables(BeamView& b, Table&& table) {
  table(b.segments, b.segmentCount);
  table(b.hops, b.hopCount);
}

// Returns the ticks of a straight walk to the goal through the waypoints ahead. The walk over
// visits counts the distance to the nearest one, and from each visit to its nearest neighbour.
OBBY_DEVICE float ticksLeft(const BeamView& b, const level::QueryView& query,
                            const sim::World& world) {
  float studs = nextRegion(query, world).distance + b.segments[world.waypoints];
  for (uint32_t i = 0; i < b.hopCount; ++i) {
    if (!(world.visited >> i & 1)) studs += b.hops[i];
  }
  return b.ticksPerStud * studs;
}

// Returns f of a cell that has not been tried, less the ticks so far.
OBBY_DEVICE uint32_t greedyTicks(const BeamView& b, const level::QueryView& query,
                                 const sim::World& world) {
  return uint32_t(kBeamGreed * ticksLeft(b, query, world));
}

}  // namespace obby::solve
