// One tick for many worlds at once on the CPU's SIMD lanes: the bits of tick() (tick.h), several
// times as fast. The phases are the same functions, run for kLanes worlds together; between phases
// the worlds are sorted by what they need, so that few lanes idle. Worlds near parts that a
// clock takes away or moves, that can be climbed, are solid from one side, crush or are no blocks,
// and worlds with a running clock, take tick() itself.
#pragma once

#include <cstddef>
#include <cstdint>

#include "level/level_view.h"
#include "sim/loose.h"
#include "sim/world.h"

namespace obby::sim {

// How worlds went, to see what a level costs; sums over calls.
struct WideCounts {
  uint64_t ticks = 0;         // of all worlds
  uint64_t single = 0;        // of these by tick()
  uint64_t contact = 0;       // of these with a solid part in the body's reach
  uint64_t looseInLanes = 0;  // loose bodies that lanes moved
};

// Advances `count` worlds by one tick, world i under actions[i]. Worlds whose playthrough has ended
// stay as they are. The worlds must be different ones. `counts` may be null.
void tickAll(const level::LevelView& level, World* const* worlds, LooseBody* const* loose,
             const Action* actions, size_t count, WideCounts* counts = nullptr);

}  // namespace obby::sim
