#include "solve/improve/line.h"

#include "solve/search/rollouts/action_runs.h"

namespace obby::solve {

Line playLine(const Problem& problem, std::span<const sim::Action> actions,
              const CostMeter& meter) {
  sim::World world = problem.start;
  std::vector<sim::RigidBody> bodies = problem.startBodies;
  Line line;
  const auto keep = [&](const CostState& cost) {
    line.worlds.push_back(world);
    line.bodies.insert(line.bodies.end(), bodies.begin(), bodies.end());
    line.costs.push_back(cost);
  };
  CostState cost;
  keep(cost);
  for (const sim::Action& action : actions) {
    if (world.outcome != sim::Outcome::running) break;
    const uint32_t jumps = world.jumps;
    sim::advance(world, bodies.data(), problem.level, &problem.query, action);
    meter.note(cost, action, world.jumps > jumps, world, bodies.data());
    line.actions.push_back(action);
    keep(cost);
  }
  return line;
}

Trajectory trajectoryOf(const Line& line) {
  Trajectory p;
  p.ticks = line.ticks();
  p.end = line.worlds.back();
  const auto bodies = line.bodiesAt(p.ticks);
  p.endBodies.assign(bodies.begin(), bodies.end());
  for (const sim::Action& action : line.actions) hold(p.actions, action);
  for (uint32_t t = 0; t <= p.ticks; ++t) {
    if (t % kPathStep == 0) p.path.push_back(line.worlds[t].position);
    if (t > 0 && line.worlds[t].jumps > line.worlds[t - 1].jumps) p.jumpTicks.push_back(t);
  }
  return p;
}

std::vector<sim::Action> actionsOf(const Trajectory& trajectory) {
  std::vector<sim::Action> actions;
  for (const sim::ActionRun& run : trajectory.actions)
    actions.insert(actions.end(), run.ticks, run.action);
  return actions;
}

}  // namespace obby::solve
