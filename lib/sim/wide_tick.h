// Advances many worlds by one tick on the CPU's SIMD lanes, with the bits of tick() (tick.h) and
// several times as fast. The phases are the same functions, run for kLanes worlds together. Between
// phases the worlds are sorted by what they need, so that few lanes idle. Worlds with a running
// clock take tick() itself. So do worlds near parts that a clock removes or moves, that can be
// climbed, are one-way, crush or are not blocks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "level/level_view.h"
#include "sim/rigid_body.h"
#include "sim/world.h"

namespace obby::sim {

// Counts of the kinds of ticks, which show the cost of a level; sums over calls.
struct WideCounts {
  uint64_t ticks = 0;          // ticks of all worlds
  uint64_t single = 0;         // ticks of worlds that tick() moved
  uint64_t contact = 0;        // ticks with a solid part in the body's reach
  uint64_t bodiesInLanes = 0;  // dynamic bodies that lanes moved
};

// Advances `count` worlds by one tick, world i under actions[i]. Worlds whose trajectory has ended
// do not change. The worlds must be different ones. `counts` may be null.
void tickAll(const level::LevelView& level, World* const* worlds, RigidBody* const* bodies,
             const Action* actions, size_t count, WideCounts* counts = nullptr);

}  // namespace obby::sim
