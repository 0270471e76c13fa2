// Replays the trajectories of an earlier answer before the first round. Solutions that still work
// are found at once. The states along the others are kept like those of any rollout.
#include "solve/search/methods/go_explore.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::solve {

void GoExplore::tryWarmStarts(size_t first, size_t count) {
  rollouts_.assign(count, {});
  machine_.pool.run(int(count), [&](int task) {
    const size_t i = size_t(task), warmStart = first + i;
    rollouts_[i].id = kWarmStart | warmStart;
    follow(rollouts_[i], problem_.known[warmStart]);
  });
  merge();
}

void GoExplore::follow(Rollout& r, const ActionRuns& warmStart) {
  r.end = problem_.start;
  r.endBodies = problem_.startBodies;
  const uint64_t key = cellKey(setup_.rules.binning, r.end, r.endBodies.data());
  Trail trail{key, key};
  playRuns(
      context(), warmStart, r.end, r.endBodies.data(), ticksOf(warmStart),
      [&](const sim::Action&, const sim::World& world) {
        if (++r.ticks % setup_.rules.rule.lookEvery != 0 || world.outcome != sim::Outcome::running)
          return;
        const uint64_t here = cellKey(setup_.rules.binning, world, r.endBodies.data());
        if (trail.isNew(here, setup_.rules.rule, world)) {
          visit(r, here, archive_.find(here), world, r.endBodies, r.ticks);
          trail.kept = here;
        }
        noteClosest(r, world, r.ticks);
      });
}

}  // namespace obby::solve
