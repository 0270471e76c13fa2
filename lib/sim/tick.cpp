#include "sim/tick.h"

#include "sim/tick_phases.h"

namespace obby::sim {

template <bool kLoose>
void tick(World& w, LooseBody* loose, const level::LevelView& level, Action action,
          uint32_t apart) {
  tickInPlace<kLoose>(w, loose, level, action, apart);
}

template void tick<false>(World&, LooseBody*, const level::LevelView&, Action, uint32_t);
template void tick<true>(World&, LooseBody*, const level::LevelView&, Action, uint32_t);

}  // namespace obby::sim
