#include "solve/explorer.h"

#include "policy/policy.h"

namespace obby::solve {

static_assert(policy::kDecisionTicks == kSteerEvery, "a policy decides when rollouts plan");

sim::Action moveOfPolicy(const ExploreContext& c, const sim::World& w, const sim::LooseBody* loose,
                         Random* random) {
  return c.pilot->decide(w, loose, random);
}

}  // namespace obby::solve
