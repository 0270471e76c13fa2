#include "solve/search/solutions.h"

#include <algorithm>

namespace obby::solve {

namespace {

bool shorter(const Way& a, const Way& b) {
  const Playthrough &p = a.playthrough, &q = b.playthrough;
  return p.ticks < q.ticks || (p.ticks == q.ticks && p.end.jumps < q.end.jumps);
}

}  // namespace

Solutions::Offer Solutions::offer(Playthrough p,
                                  const std::function<bool(const Playthrough&)>& accept) {
  Way way{std::move(p), {}, 1};
  if (identity_.prepare != nullptr) identity_.prepare(problem_, way);
  const auto isSame = [&](const Way& other) { return identity_.same(way, other); };
  const auto shortest = std::ranges::find_if(ways_, isSame);
  if (shortest != ways_.end() && !shorter(way, *shortest)) {
    if (identity_.counts) ++shortest->found;
    return Offer::known;
  }
  if (accept && !accept(way.playthrough)) return Offer::refused;
  for (const Way& other : ways_) {
    if (identity_.counts && isSame(other)) way.found += other.found;
  }
  std::erase_if(ways_, isSame);
  ways_.insert(std::upper_bound(ways_.begin(), ways_.end(), way, shorter), std::move(way));
  return Offer::kept;
}

std::vector<Playthrough> Solutions::all() const {
  std::vector<Playthrough> result;
  for (const Way& way : ways_) result.push_back(way.playthrough);
  return result;
}

std::vector<RouteTally> Solutions::routes() const {
  std::vector<RouteTally> tallies;
  for (Way way : ways_) {
    noteRoute(problem_, way);
    auto tally = std::find_if(tallies.begin(), tallies.end(),
                              [&](const RouteTally& t) { return t.route == way.route; });
    if (tally == tallies.end()) {  // the first is the shortest
      tally = tallies.insert(tally, {way.route, 0, way.playthrough.ticks});
    }
    tally->count += way.found;
  }
  std::stable_sort(tallies.begin(), tallies.end(),
                   [](const RouteTally& a, const RouteTally& b) { return a.count > b.count; });
  return tallies;
}

}  // namespace obby::solve
