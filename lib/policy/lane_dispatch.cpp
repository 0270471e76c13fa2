// Calls the functions that are compiled for this CPU's level.
#include "base/cpu_level.h"
#include "policy/lane_table.h"

extern "C" {
extern const obby::policy::LaneTable obby_policy_v1, obby_policy_v2, obby_policy_v3, obby_policy_v4;
}

namespace obby::policy {
namespace {

const LaneTable& lanes() {
  static const LaneTable* const tables[] = {&obby_policy_v1, &obby_policy_v2, &obby_policy_v3,
                                            &obby_policy_v4};
  static const LaneTable& chosen = *tables[int(cpuLevel())];
  return chosen;
}

}  // namespace

Turns observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
              float* inputs) {
  return lanes().observe(scene, world, bodies, inputs);
}

void observe(const Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
             const sim::NextRegion& next, Turns ahead, float* inputs) {
  lanes().observeNext(scene, world, bodies, next, ahead, inputs);
}

void think(const NetworkView& network, const float* inputs, float* outputs) {
  lanes().think(network, inputs, outputs);
}

sim::Action decide(const Scene& scene, const NetworkView& network, const sim::World& world,
                   const sim::RigidBody* bodies, Random* random) {
  return lanes().decide(scene, network, world, bodies, random);
}

sim::Action decideOn(const Scene& scene, const NetworkView& network, const sim::World& world,
                     const float* inputs, Turns ahead, Random* random) {
  return lanes().decideOn(scene, network, world, inputs, ahead, random);
}

}  // namespace obby::policy
