#include "solve/search/rollouts/explorer.h"

#include "policy/policy.h"

namespace obby::solve {

static_assert(policy::kDecisionTicks == kSteerEvery, "a policy decides when rollouts plan");

sim::Action moveOfPolicy(const ExploreContext& c, const sim::World& w, const sim::RigidBody* bodies,
                         Random* random) {
  const policy::Scene scene{c.level, c.query, c.pilot.surroundings};
  return policy::decide(scene, c.pilot.network, w, bodies, random);
}

}  // namespace obby::solve
