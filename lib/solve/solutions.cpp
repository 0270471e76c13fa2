#include "solve/solutions.h"

#include <algorithm>

namespace obby::solve {

namespace {

bool shorter(const Way& a, const Way& b) {
  const Playthrough &p = a.playthrough, &q = b.playthrough;
  return p.ticks < q.ticks || (p.ticks == q.ticks && p.end.jumps < q.end.jumps);
}

}  // namespace

size_t Solutions::same(const Way& way) const {
  const auto found = std::find_if(ways_.begin(), ways_.end(),
                                  [&](const Way& other) { return identity_.same(way, other); });
  return size_t(found - ways_.begin());
}

Solutions::Offer Solutions::offer(Playthrough p,
                                  const std::function<bool(const Playthrough&)>& accept) {
  Way way{std::move(p), {}, 1};
  if (identity_.prepare != nullptr) identity_.prepare(problem_, way);
  const size_t i = same(way);
  if (i < ways_.size() && !shorter(way, ways_[i])) {
    if (identity_.counts) ++ways_[i].found;
    return Offer::known;
  }
  if (accept && !accept(way.playthrough)) return Offer::refused;
  keep(std::move(way), i);
  return Offer::kept;
}

void Solutions::keep(Way way, size_t replaced) {
  if (replaced < ways_.size()) {
    if (identity_.counts) way.found += ways_[replaced].found;
    ways_.erase(ways_.begin() + std::ptrdiff_t(replaced));
  }
  ways_.insert(std::upper_bound(ways_.begin(), ways_.end(), way, shorter), std::move(way));
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
