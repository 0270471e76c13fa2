// What the beam ranks states by: f = ticks so far + kBeamGreed * ticks that are left at best + what
// the cell has been tried already. For host and device.
#pragma once

#include "sim/next_region.h"
#include "sim/world.h"

namespace obby::solve {

constexpr uint32_t kBeamTries = 4;    // rollouts from a cell in a round
constexpr float kBeamGreed = 5;       // more than 1: finds some way sooner, not the shortest
constexpr uint32_t kTriedTicks = 60;  // what a round's tries add to f: no cell waits for ever

// Plain spans, for device code.
struct BeamView {
  const float* legs = nullptr;  // (waypoints + 1), studs from a waypoint to the end; 0 for the goal
  const float* hops = nullptr;  // (visits), studs from a visit to the nearest other or to the goal
  uint32_t legCount = 0, hopCount = 0;
  float ticksPerStud = 0;
};

template <class Table>
OBBY_DEVICE void forTables(BeamView& b, Table&& table) {
  table(b.legs, b.legCount);
  table(b.hops, b.hopCount);
}

// Ticks to the goal in a straight line through the waypoints ahead, walking. Visits ahead count as
// the way to the nearest, and from each to what is nearest to it.
OBBY_DEVICE float ticksLeft(const BeamView& b, const level::QueryView& query,
                            const sim::World& world) {
  float studs = nextRegion(query, world).distance + b.legs[world.waypoints];
  for (uint32_t i = 0; i < b.hopCount; ++i) {
    if (!(world.visited >> i & 1)) studs += b.hops[i];
  }
  return b.ticksPerStud * studs;
}

// f of a cell that has not been tried, less the ticks so far.
OBBY_DEVICE uint32_t greedyTicks(const BeamView& b, const level::QueryView& query,
                                 const sim::World& world) {
  return uint32_t(kBeamGreed * ticksLeft(b, query, world));
}

}  // namespace obby::solve
