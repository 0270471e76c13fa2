// Tries the trajectories of an earlier answer. The host plays them, as it does for GoExplore, and
// the device takes their visits like those of a rollout.
#include "solve/search/resident/resident_explore.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::solve {

void ResidentExplore::tryWarmStarts(size_t first, size_t count) {
  onDevice([&]() -> Status {
    OBBY_RETURN_IF_ERROR(open());
    return follow(first, count);
  });
  known_.emplace_back(first, count);
}

Status ResidentExplore::follow(size_t first, size_t count) {
  OBBY_ASSIGN(const RoundFindings found, rounds_->take(kWarmStart | first, play(first, count)));
  take(found, kWarmStart | first, uint32_t(count));
  return {};
}

PlayedStarts ResidentExplore::play(size_t first, size_t count) {
  const RolloutRules& rules = setup_.rules;
  const size_t bodyCount = problem_.startBodies.size();
  PlayedStarts played;
  for (size_t i = 0; i < count; ++i) {
    const uint32_t looks = ticksOf(problem_.known[first + i]) / rules.rule.lookEvery;
    played.capacity = std::max(played.capacity, looks + 1);
  }
  const size_t all = count * played.capacity;
  played.trajectories.resize(count);
  played.worlds.resize(all);
  played.keys.resize(all);
  played.ticks.resize(all);
  played.bodies.resize(all * bodyCount);
  machine_.pool.run(int(count), [&](int task) {
    const size_t i = size_t(task);
    PlayedStart& to = played.trajectories[i];
    to.end = problem_.start;
    std::vector<sim::RigidBody> bodies = problem_.startBodies;
    const auto visit = [&](uint64_t key, const sim::World& world, uint32_t tick) {
      const size_t at = i * played.capacity + to.visits++;
      played.worlds[at] = world;
      played.keys[at] = key;
      played.ticks[at] = tick;
      std::copy(bodies.begin(), bodies.end(), played.bodies.begin() + ptrdiff_t(at * bodyCount));
    };
    const uint64_t key = cellKey(rules.binning, to.end, bodies.data());
    RolloutWatch<decltype(visit)&> watch{rules, bodies.data(), {key, key}, visit};
    const ActionRuns& runs = problem_.known[first + i];
    const uint32_t ticks =
        playRuns(rules.context, runs, to.end, bodies.data(), ticksOf(runs), watch);
    to.path = {watch.closest, watch.closestTicks, ticks};
  });
  return played;
}

}  // namespace obby::solve
