// Asks the solver about generated levels.
#pragma once

#include "gen/made.h"
#include "policy/shipped_policy.h"
#include "solve/methods.h"
#include "solve/query_solver.h"

namespace obby::test {

// Returns the options of obby-solve's default search, limited by steps, without failed attempts.
inline solve::SolverOptions limitedTo(uint64_t steps) {
  solve::SolverOptions options;
  options.method = solve::findMethod("auto");
  options.policy = &policy::shippedPolicy().network;
  options.progressRecords = false;
  options.budget.maxSteps = steps;
  options.budget.attempts = 0;
  return options;
}

// Asks the level's query. `write` receives the records of the answer.
inline schema::Verdict ask(const Made& made, const solve::SolverOptions& options,
                           const std::function<Status(schema::Record::Reader)>& write) {
  io::RecordBuilder copy(made.level.reader());
  const auto level = solve::loadLevel(io::Record(std::move(copy)));
  EXPECT_TRUE(level) << level.error().text();
  ThreadPool pool(1);
  const auto answer =
      solve::solveQuery(*level, made.query.reader().getQuery(), options, {pool}, {write, {}, {}});
  EXPECT_TRUE(answer) << answer.error().text();
  return answer->verdict;
}

}  // namespace obby::test
