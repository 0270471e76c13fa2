#include "solve/search/run_search.h"

#include <algorithm>
#include <optional>

#include "base/stopwatch.h"

namespace obby::solve {

namespace {

constexpr size_t kChecksPerRound = 16;  // trajectories to the goal that a round regenerates

// Offers the first `max` of the goals that the search has just found.
void takeGoals(const Search& search, size_t max, size_t wanted, const Watcher& watcher,
               const Stopwatch& watch, Solutions& solutions, SearchOutcome& outcome) {
  for (size_t i = 0; i < std::min(search.goals().size(), max); ++i) {
    const bool first = solutions.count() == 0;
    const auto offer = solutions.offer(search.trajectoryTo(search.goals()[i]), watcher.accept);
    if (offer == Solutions::Offer::refused) ++outcome.refused;
    if (offer != Solutions::Offer::kept) continue;
    if (first) outcome.firstSolution = watch.seconds();
    if (solutions.count() >= wanted) return;
  }
}

std::optional<Stopped> whyStop(const Budget& budget, const Search& search, const Stopwatch& watch,
                               const Solutions& solutions) {
  if (solutions.count() >= budget.solutions) return Stopped::solved;
  if (budget.stop != nullptr && budget.stop->load()) return Stopped::interrupted;
  if (search.statistics().steps >= budget.maxSteps) return Stopped::outOfSteps;
  if (watch.seconds() >= budget.seconds) return Stopped::outOfTime;
  return std::nullopt;
}

// Returns the closest approach, then trajectories whose ends are far apart.
std::vector<Trajectory> showAttempts(const Search& search, size_t count) {
  std::vector<Trajectory> result;
  const Closest& closest = search.statistics().closest;
  if (count > 0 && closest.node.parent != kNone)
    result.push_back(search.trajectoryTo(closest.node));
  if (count <= result.size()) return result;
  for (const AttemptEnd& end : search.attempts().sample(count - result.size(), closest.position)) {
    result.push_back(search.trajectoryTo(end.node));
  }
  return result;
}

}  // namespace

SearchOutcome runSearch(const Problem& problem, const Budget& budget, const Watcher& watcher,
                        const MakeSearch& makeSearch) {
  const Stopwatch watch;
  const std::unique_ptr<Search> made = makeSearch();
  Search& search = *made;
  CoverageLog coverage;
  Solutions solutions(problem, budget.diverse ? byRoute() : byPath());
  SearchOutcome outcome;
  std::optional<Stopped> stopped;
  // An earlier answer lists its solutions first, and usually they still work. So they are tried
  // first.
  const size_t all = problem.known.size();
  for (size_t first = 0, next = budget.solutions; first < all && !stopped;
       first = next, next = all) {
    search.tryWarmStarts(first, std::min(next, all) - first);
    // All goals are taken, since the trajectories are not tried again.
    takeGoals(search, all, budget.solutions, watcher, watch, solutions, outcome);
    outcome.knownSolutions = uint32_t(solutions.count());
    if (outcome.knownSolutions >= budget.solutions) stopped = Stopped::solved;
  }
  while (!stopped) {
    search.round();
    coverage.note(search);
    takeGoals(search, kChecksPerRound, budget.solutions, watcher, watch, solutions, outcome);
    const bool wanted = !watcher.look || watcher.look({search, watch.seconds()});
    stopped = wanted ? whyStop(budget, search, watch, solutions) : Stopped::interrupted;
  }
  outcome.stopped = *stopped;
  outcome.seconds = watch.seconds();
  outcome.solutions = solutions.all();
  outcome.diverse = budget.diverse;
  if (budget.solutions > 1) outcome.routes = solutions.routes();
  outcome.attempts = showAttempts(search, budget.attempts);
  outcome.ends = search.attempts().counts();
  outcome.statistics = search.statistics();
  outcome.coverage = coverage.finish(search);
  outcome.targetCount = targetCount(problem.query);
  outcome.cells = search.cellCount();
  outcome.device = search.deviceStatus();
  return outcome;
}

}  // namespace obby::solve
