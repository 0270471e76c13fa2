#include "solve/answers/pass_filter.h"

#include <algorithm>

#include "sim/simulator.h"
#include "solve/query/build_query.h"

namespace obby::solve {

Result<PassFilter> PassFilter::make(schema::Level::Reader record, const level::Level& level,
                                    const PassRule& rule) {
  OBBY_ASSIGN(const io::Record places, buildPlaces(record, rule.pass, rule.notPass));
  const auto query = places.reader().getQuery();
  level::ColliderRuns runs(level.view());
  PassFilter filter;
  for (const auto region : query.getVisits()) filter.pass_.emplace_back(region, runs);
  for (const auto region : query.getAvoid()) filter.notPass_.emplace_back(region, runs);
  return filter;
}

Result<bool> PassFilter::keeps(const level::Level& level,
                               schema::Trajectory::Reader trajectory) const {
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(trajectory));
  const sim::Replay replay = sim::replay(level.view(), nullptr, plan);
  const std::vector<sim::World>& worlds = replay.worlds;
  // Between two ticks, too: a box may be thinner than a player walks in one.
  const auto passes = [&](const Place& place) {
    if (place.holds(level.view(), worlds[0], replay.looseAt(0))) return true;
    for (size_t tick = 1; tick < worlds.size(); ++tick) {
      const sim::World &before = worlds[tick - 1], &world = worlds[tick];
      if (place.isEntered(level.view(), before, world, replay.looseAt(tick))) return true;
    }
    return false;
  };
  return std::ranges::all_of(pass_, passes) && std::ranges::none_of(notPass_, passes);
}

}  // namespace obby::solve
