#include "solve/search/solutions.h"

#include <algorithm>

namespace obby::solve {

namespace {

bool shorter(const Solution& a, const Solution& b) {
  const Trajectory &p = a.trajectory, &q = b.trajectory;
  return p.ticks < q.ticks || (p.ticks == q.ticks && p.end.jumps < q.end.jumps);
}

}  // namespace

Solutions::Offer Solutions::offer(Trajectory p,
                                  const std::function<bool(const Trajectory&)>& accept) {
  Solution solution{std::move(p), {}, 1};
  if (identity_.prepare != nullptr) identity_.prepare(problem_, solution);
  const auto isSame = [&](const Solution& other) { return identity_.same(solution, other); };
  const auto shortest = std::ranges::find_if(solutions_, isSame);
  if (shortest != solutions_.end() && !shorter(solution, *shortest)) {
    if (identity_.counts) ++shortest->found;
    return Offer::known;
  }
  if (accept && !accept(solution.trajectory)) return Offer::refused;
  for (const Solution& other : solutions_) {
    if (identity_.counts && isSame(other)) solution.found += other.found;
  }
  std::erase_if(solutions_, isSame);
  solutions_.insert(std::upper_bound(solutions_.begin(), solutions_.end(), solution, shorter),
                    std::move(solution));
  return Offer::kept;
}

std::vector<Trajectory> Solutions::all() const {
  std::vector<Trajectory> result;
  for (const Solution& solution : solutions_) result.push_back(solution.trajectory);
  return result;
}

std::vector<RouteTally> Solutions::routes() const {
  std::vector<RouteTally> tallies;
  for (Solution solution : solutions_) {
    noteRoute(problem_, solution);
    auto tally = std::find_if(tallies.begin(), tallies.end(),
                              [&](const RouteTally& t) { return t.route == solution.route; });
    if (tally == tallies.end()) {  // the first is the shortest
      tally = tallies.insert(tally, {solution.route, 0, solution.trajectory.ticks});
    }
    tally->count += solution.found;
  }
  std::stable_sort(tallies.begin(), tallies.end(),
                   [](const RouteTally& a, const RouteTally& b) { return a.count > b.count; });
  return tallies;
}

}  // namespace obby::solve
