// Advances one world by one tick. Deterministic: equal state, level and action result in equal bits
// on every backend (docs/determinism.md).
#pragma once

#if defined(__CUDACC__)
#include "sim/tick_phases.h"
#else
#include "level/level_view.h"
#include "sim/actions.h"
#include "sim/rigid_body.h"
#include "sim/world.h"
#endif

namespace obby::sim {

// Advances `w` and its dynamic bodies (null if the level has none) by one tick. Does nothing to a
// world whose trajectory has ended. Never allocates; overruns set bits in w.flags. `apart` has a
// bit for each body that the caller moves; those meet neither the player nor another body. On the
// CPU this is a separate function (tick.cpp): the call costs little, and compiling it takes as long
// as a hundred small sources.
#if defined(__CUDACC__)
template <bool kDynamic = true>
OBBY_DEVICE void tick(World& w, RigidBody* bodies, const level::LevelView& level, Action action,
                      uint32_t apart = 0) {
  tickInPlace<kDynamic>(w, bodies, level, action, apart);
}
#else
template <bool kDynamic = true>
void tick(World& w, RigidBody* bodies, const level::LevelView& level, Action action,
          uint32_t apart = 0);
#endif

}  // namespace obby::sim
