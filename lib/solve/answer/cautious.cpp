#include "solve/answer/cautious.h"

#include <algorithm>
#include <set>

#include "solve/verify/posed_query.h"

namespace obby::solve {

namespace {

constexpr uint64_t kMinSteps = 500'000;
constexpr uint64_t kTimesSteps = 8;  // max steps, as a multiple of the first search's
constexpr float kDeadly = 1e6f;      // damage above any health

// Returns the parts that every solution touches because the query names them.
std::set<uint32_t> namedParts(schema::Query::Reader query) {
  std::set<uint32_t> parts;
  const auto add = [&](schema::Region::Reader region) {
    if (region.getPartIndex() >= 0) parts.insert(uint32_t(region.getPartIndex()));
  };
  add(query.getGoal());
  for (const auto region : query.getGoals()) add(region);
  for (const auto region : query.getVisits()) add(region);
  for (const auto waypoint : query.getWaypoints()) add(waypoint.getRegion());
  return parts;
}

// Returns the level with these parts deadly and not solid. If they were solid, the simulator would
// sense a floor before the feet touch it.
Result<LoadedLevel> withDeadly(const io::Record& level, const std::vector<uint32_t>& parts) {
  io::RecordBuilder copy(level.reader());
  auto all = copy.root().getLevel().getParts();
  for (const uint32_t part : parts) {
    all[part].setSolid(false);
    all[part].setTouch(true);
    all[part].setByRoot(false);
    all[part].initKill().setDamage(kDeadly);
  }
  return loadLevel(io::Record(std::move(copy)));
}

// Returns true if a loss or doubt about anything but the deadly parts could make the game easier.
bool mayBeEasierElsewhere(schema::Level::Reader level, const std::vector<uint32_t>& deadly) {
  for (const auto loss : level.getUnmodelled()) {
    if (loss.getAnywhere() && loss.getBearing() != schema::Bearing::HARDER) return true;
  }
  const auto parts = level.getParts();
  for (uint32_t i = 0; i < parts.size(); ++i) {
    const bool isDeadly = std::ranges::binary_search(deadly, i);
    if (parts[i].getDoubts().size() > 0 && !isDeadly) return true;
  }
  return false;
}

// Returns the rest of the budget. Its steps are limited to kMinSteps or kTimesSteps times those of
// the first search, whichever is more.
Budget budgetAfter(Budget budget, const SearchOutcome& first) {
  const uint64_t steps = first.statistics.steps;
  budget.maxSteps -= std::min(budget.maxSteps, steps);
  budget.maxSteps = std::min(budget.maxSteps, std::max(kMinSteps, kTimesSteps * steps));
  budget.seconds = std::max(0.0, budget.seconds - first.seconds);
  return budget;
}

}  // namespace

Result<Avoiding> avoidDoubts(const SolvedQuery& solved, const Machine& machine,
                             const Course& course, std::vector<uint32_t>& touched,
                             SearchOutcome& outcome) {
  const auto record = solved.level.record.reader().getLevel();
  const level::LevelView& view = solved.level.level.view();
  std::set<uint32_t> needed = namedParts(solved.query);
  for (const uint32_t part : touchedOf(touched, view, course, 1)) needed.insert(part);
  const auto isNeeded = [&](uint32_t part) { return needed.contains(part); };
  if (std::ranges::all_of(touched, isNeeded)) return Avoiding::notTried;
  std::vector<uint32_t> deadly = solved.doubtful;
  std::erase_if(deadly, isNeeded);

  OBBY_ASSIGN(const LoadedLevel level, withDeadly(solved.level.record, deadly));
  OBBY_ASSIGN(const level::Query query, level::Query::compile(solved.query, level.level));
  const PosedQuery posed{level.level, level.record.reader().getLevel(), query, solved.query,
                         solved.options.policy};
  const Problem problem = problemOf(posed);
  if (isCut(problem, solved.query))
    return mayBeEasierElsewhere(record, deadly) ? Avoiding::notFound : Avoiding::impossible;
  SearchOutcome found = solved.options.method->run(
      problem, budgetAfter(solved.options.budget, outcome), solved.watcher, machine);
  outcome.statistics.steps += found.statistics.steps;
  outcome.seconds += found.seconds;
  if (found.solutions.empty()) return Avoiding::notFound;
  outcome.solutions = std::move(found.solutions);
  outcome.routes = std::move(found.routes);
  outcome.knownSolutions = 0;
  outcome.cells = found.cells;
  outcome.statistics.rounds += found.statistics.rounds;
  outcome.firstSolution = outcome.seconds - found.seconds + found.firstSolution;
  touched = touchedOf(solved.doubtful, view, courseOf(solved.problem, outcome.solutions.front()));
  return Avoiding::notTried;
}

}  // namespace obby::solve
