#include "solve/report/answer_records.h"

#include "level/record_values.h"
#include "level/tricks.h"
#include "solve/report/reason.h"

namespace obby::solve {

namespace {

constexpr size_t kProgressDeaths = 3;  // deaths in a progress record

void fillEnds(schema::Result::Builder record, const std::vector<EndCount>& ends) {
  auto tallies = record.initEnds(uint32_t(ends.size()));
  for (uint32_t i = 0; i < tallies.size(); ++i) {
    tallies[i].setOutcome(schema::Outcome(ends[i].outcome));
    fillBlame(tallies[i], ends[i].outcome, ends[i].part);
    tallies[i].setCount(ends[i].count);
  }
}

void fillRoutes(schema::Result::Builder record, const std::vector<RouteTally>& routes) {
  auto counts = record.initRoutes(uint32_t(routes.size()));
  for (uint32_t i = 0; i < counts.size(); ++i) {
    fillRoute(counts[i], routes[i].route);
    counts[i].setCount(routes[i].count);
    counts[i].setTicks(routes[i].ticks);
  }
}

void fillCut(schema::Cut::Builder record, const Cut& cut, const level::LevelView& level) {
  auto reached = record.initReached(uint32_t(cut.reached.size()));
  for (uint32_t i = 0; i < reached.size(); ++i) reached.set(i, int32_t(cut.reached[i]));
  const auto partOf = [&](uint32_t collider) {
    return collider == level::kNone ? -1 : int32_t(level.colliders[collider].part);
  };
  record.setFrom(partOf(cut.missing.from));
  record.setTo(partOf(cut.missing.to));
  record.setRise(cut.missing.rise);
  record.setGap(cut.missing.gap);
  record.setJumps(cut.jumps);
  record.setSeconds(cut.seconds);
  record.setWithTricks(cut.withTricks);
  const auto tricks = level::tricksIn(cut.mayHelp);
  auto mayHelp = record.initMayHelp(uint32_t(tricks.size()));
  for (uint32_t i = 0; i < mayHelp.size(); ++i) mayHelp.set(i, tricks[i]);
}

}  // namespace

void fillProgress(schema::Progress::Builder record, const AnswerIdentity& identity,
                  const SearchView& view, bool paths) {
  const Statistics& s = view.search.statistics();
  record.setQuery(identity.query);
  record.setSeconds(float(view.seconds));
  record.setSteps(s.steps);
  record.setCells(view.search.cellCount());
  record.setRounds(s.rounds);
  record.setClosest(s.closest.distance);
  record.setWaypoints(s.closest.targets);
  uint32_t index = 0;
  const auto fillEnd = [&](schema::Trajectory::Builder to, const Node& end) {
    const Trajectory trajectory = view.search.trajectoryTo(end);
    fillTrajectory(to, identity, trajectory, index++);
    if (paths) fillPath(to, trajectory);
  };
  if (s.closest.node.parent != kNone) fillEnd(record.initBest(), s.closest.node);
  const Node newest = view.search.newest();
  if (newest.parent != kNone) fillEnd(record.initNewest(), newest);
  const auto ends = view.search.attempts().newestFailures(kProgressDeaths);
  auto deaths = record.initDeaths(uint32_t(ends.size()));
  for (uint32_t i = 0; i < deaths.size(); ++i) fillEnd(deaths[i], ends[i].node);
}

void fillFirstSolution(schema::Progress::Builder record, const AnswerIdentity& identity,
                       const Trajectory& solution, double seconds, bool paths) {
  record.setQuery(identity.query);
  record.setSeconds(float(seconds));
  fillTrajectory(record.initSolution(), identity, solution, 0);
  if (paths) fillPath(record.getSolution(), solution);
}

schema::Verdict verdictOf(const SearchOutcome& outcome) {
  if (!outcome.solutions.empty()) return schema::Verdict::SOLVED;
  return outcome.cut ? schema::Verdict::UNREACHABLE : schema::Verdict::UNKNOWN;
}

void fillResult(schema::Result::Builder record, const AnswerIdentity& identity,
                const SearchOutcome& outcome, const level::Level& level,
                schema::Level::Reader levelRecord, schema::Query::Reader query) {
  const bool solved = !outcome.solutions.empty();
  record.setQuery(identity.query);
  record.setLevel(identity.level);
  record.setMethod(identity.method);
  record.setVerdict(verdictOf(outcome));
  level::setTricks(record, identity.tricks);
  record.setSolutions(uint32_t(outcome.solutions.size()));
  if (solved) {
    record.setTicks(outcome.solutions.front().ticks);
    record.setJumps(outcome.solutions.front().end.jumps);
  }
  record.setSteps(outcome.statistics.steps);
  record.setCells(outcome.cells);
  record.setRounds(outcome.statistics.rounds);
  if (!solved && !outcome.cut) {
    record.setClosest(outcome.statistics.closest.distance);
    fillEvidence(record.initEvidence(), outcome.coverage);
  }
  if (outcome.cut) fillCut(record.initCut(), *outcome.cut, level.view());
  record.setReason(reasonFor(outcome, level, levelRecord, query));
  if (!outcome.routes.empty()) fillRoutes(record, outcome.routes);
  fillEnds(record, outcome.ends);
  auto timing = record.initTiming();
  timing.setSeconds(float(outcome.seconds));
  timing.setFirstSolution(float(outcome.firstSolution));
  timing.setStepsPerSecond(double(outcome.statistics.steps) / std::max(outcome.seconds, 1e-9));
}

}  // namespace obby::solve
