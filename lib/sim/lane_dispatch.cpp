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

template <bool kDynamic>
void tick(World& w, RigidBody* bodies, const level::LevelView& level, Action action,
          uint32_t apart) {
  (kDynamic ? lanes().tick : lanes().tickWithoutBodies)(w, bodies, level, action, apart);
}

template void tick<false>(World&, RigidBody*, const level::LevelView&, Action, uint32_t);
template void tick<true>(World&, RigidBody*, const level::LevelView&, Action, uint32_t);

void tickAll(const level::LevelView& level, World* const* worlds, RigidBody* const* bodies,
             const Action* actions, size_t count, WideCounts* counts) {
  lanes().tickAll(level, worlds, bodies, actions, count, counts);
}

}  // namespace obby::sim
