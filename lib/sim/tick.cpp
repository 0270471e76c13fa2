#include "sim/tick.h"

#include "sim/tick_phases.h"

namespace obby::sim {

template <bool kDynamic>
void tick(World& w, RigidBody* bodies, const level::LevelView& level, Action action,
          uint32_t apart) {
  tickInPlace<kDynamic>(w, bodies, level, action, apart);
}

template void tick<false>(World&, RigidBody*, const level::LevelView&, Action, uint32_t);
template void tick<true>(World&, RigidBody*, const level::LevelView&, Action, uint32_t);

}  // namespace obby::sim
