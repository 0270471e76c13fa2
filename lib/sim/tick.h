// One tick for one world. Deterministic: equal state, level and action in, equal bits out on every
// backend (docs/determinism.md).
#pragma once

#if defined(__CUDACC__)
#include "sim/tick_phases.h"
#else
#include "level/level_view.h"
#include "sim/actions.h"
#include "sim/loose.h"
#include "sim/world.h"
#endif

namespace obby::sim {

// Advances `w` and the loose bodies beside it (null where the level has none) by one tick. Nothing
// happens to a world whose playthrough has ended. Never allocates; overruns set bits in w.flags.
// `apart`: bodies that the caller moves, a bit each; they meet neither the player nor another body.
// On the CPU it is a function of its own (tick.cpp): its call is nothing beside its work, and
// compiling it takes as long as a hundred small sources.
#if defined(__CUDACC__)
template <bool kLoose = true>
OBBY_DEVICE void tick(World& w, LooseBody* loose, const level::LevelView& level, Action action,
                      uint32_t apart = 0) {
  tickInPlace<kLoose>(w, loose, level, action, apart);
}
#else
template <bool kLoose = true>
void tick(World& w, LooseBody* loose, const level::LevelView& level, Action action,
          uint32_t apart = 0);
#endif

}  // namespace obby::sim
