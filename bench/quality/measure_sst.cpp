#include "quality/measure_sst.h"

#include <fmt/format.h>

#include "io/record.h"
#include "sim/player.h"
#include "solve/answer/loaded_level.h"
#include "solve/improve/line.h"
#include "solve/improve/preference.h"
#include "solve/model/trajectory_record.h"
#include "solve/verify/posed_query.h"
#include "solve/verify/verifier.h"

namespace obby::bench {

namespace {

constexpr uint64_t kSeed = 1;

// Plays the actions until the trajectory ends.
solve::Trajectory played(const solve::Problem& problem, const solve::ActionRuns& runs) {
  std::vector<sim::Action> actions;
  for (sim::ActionRun run : runs) {
    run.action.heading =
        Turns(sim::walkableHeading<int32_t>(run.action.heading, problem.level.params));
    actions.insert(actions.end(), run.ticks, run.action);
  }
  const solve::CostMeter meter(problem, solve::preferences().front().weights, problem.bounds);
  return solve::trajectoryOf(solve::playLine(problem, actions, meter));
}

// Returns nothing if the verifier rejects the solution.
std::optional<Quality> verified(const solve::PosedQuery& posed, const solve::Problem& problem,
                                const solve::ActionRuns& runs) {
  const solve::Trajectory trajectory = played(problem, runs);
  io::RecordBuilder record;
  const solve::AnswerIdentity identity{
      posed.query.id(), posed.level.name(), posed.query.start(), {}, posed.query.view().tricks, {}};
  solve::fillTrajectory(record.root().initTrajectory(), identity, trajectory, 0);
  solve::fillPath(record.root().getTrajectory(), trajectory);
  const auto written = record.reader().getTrajectory();
  Status status = solve::verify(posed.level, posed.levelRecord, posed.queryRecord, written);
  if (status && written.getOutcome() == schema::Outcome::GOAL) return qualityOf(written);
  fmt::print(stderr, "bench_quality: SST's solution of {} fails the verifier: {}\n",
             posed.query.id(), status ? "it misses the goal" : status.error().text());
  return std::nullopt;
}

}  // namespace

std::vector<std::optional<Quality>> measureSst(const SuiteQuery& query,
                                               std::span<const uint64_t> budgets,
                                               const SstSettings& settings) {
  std::vector<std::optional<Quality>> out(budgets.size());
  const auto level = solve::loadLevel(query.level);
  if (!level) return out;
  const auto record = query.query.reader().getQuery();
  const auto compiled = level::Query::compile(record, level->level);
  if (!compiled) return out;
  const solve::PosedQuery posed{level->level, level->record.reader().getLevel(), *compiled, record};
  const solve::Problem problem = solve::problemOf(posed);
  SstPlanner planner(problem, settings, kSeed);
  for (size_t i = 0; i < budgets.size(); ++i) {
    const auto runs = planner.run(budgets[i]);
    if (runs) out[i] = verified(posed, problem, *runs);
    if (!out[i]) continue;
    out[i]->firstSeconds = planner.firstSeconds();
    out[i]->finalSeconds = planner.seconds();
    out[i]->steps = budgets[i];
  }
  return out;
}

}  // namespace obby::bench
