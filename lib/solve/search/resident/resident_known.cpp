// Tries the trajectories of an earlier answer. The host plays them, as it does for GoExplore, and
// the device takes their visits like those of a rollout.
#include "solve/search/resident/resident_explore.h"
#include "solve/search/rollouts/known_way.h"

namespace obby::solve {

void ResidentExplore::tryKnown(size_t first, size_t count) {
  onDevice([&]() -> Status {
    OBBY_RETURN_IF_ERROR(open());
    return follow(first, count);
  });
  known_.emplace_back(first, count);
}

Status ResidentExplore::follow(size_t first, size_t count) {
  OBBY_ASSIGN(const RoundFindings found, rounds_->take(kKnown | first, play(first, count)));
  take(found, kKnown | first, uint32_t(count));
  return {};
}

PlayedWays ResidentExplore::play(size_t first, size_t count) {
  const RolloutRules& rules = setup_.rules;
  const size_t bodies = problem_.startLoose.size();
  PlayedWays played;
  for (size_t i = 0; i < count; ++i) {
    const uint32_t looks = ticksOf(problem_.known[first + i]) / rules.rule.lookEvery;
    played.room = std::max(played.room, looks + 1);
  }
  const size_t all = count * played.room;
  played.ways.resize(count);
  played.worlds.resize(all);
  played.keys.resize(all);
  played.ticks.resize(all);
  played.loose.resize(all * bodies);
  machine_.pool.run(int(count), [&](int task) {
    const size_t i = size_t(task);
    PlayedWay& to = played.ways[i];
    to.end = problem_.start;
    std::vector<sim::LooseBody> loose = problem_.startLoose;
    const auto visit = [&](uint64_t key, const sim::World& world, uint32_t tick) {
      const size_t at = i * played.room + to.visits++;
      played.worlds[at] = world;
      played.keys[at] = key;
      played.ticks[at] = tick;
      std::copy(loose.begin(), loose.end(), played.loose.begin() + ptrdiff_t(at * bodies));
    };
    const uint64_t key = cellKey(rules.binning, to.end, loose.data());
    RolloutWatch<decltype(visit)&> watch{rules, loose.data(), {key, key}, visit};
    const KnownWay& way = problem_.known[first + i];
    const uint32_t ticks = runKnown(rules.context, way, to.end, loose.data(), ticksOf(way), watch);
    to.path = {watch.closest, watch.closestTicks, ticks};
  });
  return played;
}

}  // namespace obby::solve
