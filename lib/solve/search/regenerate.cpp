#include "solve/search/regenerate.h"

#include "sim/player.h"
#include "solve/search/rollouts/action_runs.h"
#include "solve/search/rollouts/rollout.h"

namespace obby::solve {

Trajectory regenerate(const ExploreContext& context, uint64_t seed, const Problem& problem,
                      const ChunkedVector<Node>& nodes, const Node& end) {
  std::vector<const Node*> chain;
  for (const Node* n = &end; n->parent != kNone; n = &nodes[n->parent]) chain.push_back(n);
  Trajectory p;
  p.end = problem.start;
  p.endBodies = problem.startBodies;
  p.path.push_back(problem.start.position);
  uint32_t jumps = problem.start.jumps;
  const auto note = [&](const sim::Action& action, const sim::World& world) {
    sim::Action walked = action;
    walked.heading = Turns(sim::walkableHeading<int32_t>(action.heading, problem.level.params));
    hold(p.actions, walked);
    if (++p.ticks % kPathStep == 0) p.path.push_back(world.position);
    if (world.jumps > jumps) p.jumpTicks.push_back(p.ticks);
    jumps = world.jumps;
  };
  for (auto n = chain.rbegin(); n != chain.rend(); ++n) {
    const Node& node = **n;
    if (node.rollout & kWarmStart) {
      playRuns(context, problem.known[node.rollout & ~kWarmStart], p.end, p.endBodies.data(),
               node.ticks, note);
    } else {
      runRollout<true, true>(context, seed, node.rollout, p.end, p.endBodies.data(), node.ticks,
                             note);
    }
  }
  return p;
}

}  // namespace obby::solve
