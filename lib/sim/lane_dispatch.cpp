// Calls the functions that are compiled for this CPU's level.
#include "base/cpu_level.h"
#include "sim/lane_table.h"

extern "C" {
extern const obby::sim::LaneTable obby_sim_v1, obby_sim_v2, obby_sim_v3, obby_sim_v4;
}

namespace obby::sim {
namespace {

const LaneTable& lanes() {
  static const LaneTable* const tables[] = {&obby_sim_v1, &obby_sim_v2, &obby_sim_v3, &obby_sim_v4};
  static const LaneTable& chosen = *tables[int(cpuLevel())];
  return chosen;
}

}  // namespace

template <bool kLoose>
void tick(World& w, LooseBody* loose, const level::LevelView& level, Action action,
          uint32_t apart) {
  (kLoose ? lanes().tick : lanes().tickWithoutLoose)(w, loose, level, action, apart);
}

template void tick<false>(World&, LooseBody*, const level::LevelView&, Action, uint32_t);
template void tick<true>(World&, LooseBody*, const level::LevelView&, Action, uint32_t);

void tickAll(const level::LevelView& level, World* const* worlds, LooseBody* const* loose,
             const Action* actions, size_t count, WideCounts* counts) {
  lanes().tickAll(level, worlds, loose, actions, count, counts);
}

}  // namespace obby::sim
