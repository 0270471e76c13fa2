#include "solve/pass_filter.h"

#include <algorithm>

#include "sim/simulator.h"
#include "solve/model/build_query.h"

namespace obby::solve {

Result<PassFilter> PassFilter::make(schema::Level::Reader record, const level::Level& level,
                                    const PassRule& rule) {
  OBBY_ASSIGN(const io::Record places, buildPlaces(record, rule.pass, rule.notPass));
  const auto query = places.reader().getQuery();
  level::ColliderRuns runs(level.view());
  PassFilter filter;
  const auto placeOf = [&](schema::Region::Reader region) {
    return Place(region, runs, schema::Arrive::TOUCH, level.view());
  };
  for (const auto region : query.getVisits()) filter.pass_.push_back(placeOf(region));
  for (const auto region : query.getAvoid()) filter.notPass_.push_back(placeOf(region));
  return filter;
}

Result<bool> PassFilter::keeps(const level::Level& level,
                               schema::Trajectory::Reader trajectory) const {
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(trajectory));
  std::vector<Place> missing = pass_;
  bool entered = false;  // true once a place of notPass_ is entered
  sim::replay(level.view(), nullptr, plan, [&](const sim::Moment& now) {
    // Boxes are tested between ticks, too: a player may cross a thin one within a tick.
    const auto passes = [&](const Place& place) {
      if (now.tick == 0) return place.holds(level.view(), now.world, now.bodies);
      return place.isEntered(level.view(), now.before, now.world, now.bodies);
    };
    std::erase_if(missing, passes);
    entered = std::ranges::any_of(notPass_, passes);
    const bool decided = entered || (missing.empty() && notPass_.empty());
    return !decided;
  });
  return missing.empty() && !entered;
}

}  // namespace obby::solve
