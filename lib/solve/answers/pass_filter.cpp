#include "solve/answers/pass_filter.h"

#include <algorithm>

#include "sim/simulator.h"
#include "solve/query/build_query.h"

namespace obby::solve {

Result<PassFilter> PassFilter::make(schema::Level::Reader level, const PassRule& rule) {
  OBBY_ASSIGN(const io::Record record, buildPlaces(level, rule.pass, rule.notPass));
  const auto query = record.reader().getQuery();
  PassFilter filter;
  for (const auto region : query.getVisits()) filter.pass_.emplace_back(region);
  for (const auto region : query.getAvoid()) filter.notPass_.emplace_back(region);
  return filter;
}

Result<bool> PassFilter::keeps(const level::Level& level,
                               schema::Trajectory::Reader trajectory) const {
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(trajectory));
  const sim::Replay replay = sim::replay(level.view(), nullptr, plan);
  const auto passes = [&](const Place& place) {
    for (size_t tick = 0; tick < replay.worlds.size(); ++tick) {
      if (place.holds(level.view(), replay.worlds[tick], replay.looseAt(tick))) return true;
    }
    return false;
  };
  return std::ranges::all_of(pass_, passes) && std::ranges::none_of(notPass_, passes);
}

}  // namespace obby::solve
