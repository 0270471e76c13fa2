#include "suite/ask.h"

#include "common/report.h"
#include "policy/shipped_policy.h"
#include "solve/query_solver.h"

namespace obby::bench {
namespace {

const char* nameOf(schema::Verdict verdict) {
  switch (verdict) {
    case schema::Verdict::SOLVED: return "solved";
    case schema::Verdict::UNREACHABLE: return "unreachable";
    case schema::Verdict::UNKNOWN: break;
  }
  return "unknown";
}

}  // namespace

Run plannedRun(const Trial& trial, uint64_t program) {
  Run run;
  run.method = trial.method.name;
  run.file = trial.query.file;
  run.query = trial.query.id;
  run.expected = trial.query.expected;
  run.seed = trial.seed;
  run.cap = trial.cap;
  run.content = trial.query.content;
  run.program = program;
  return run;
}

Result<std::optional<Run>> ask(const Trial& trial, Run run, ThreadPool& pool,
                               const std::atomic<bool>& stop) {
  solve::SolverOptions options;
  options.budget.seed = trial.seed;
  options.budget.seconds = trial.cap;
  options.budget.stop = &stop;
  options.method = &trial.method;
  options.policy = &policy::shippedPolicy().network;
  options.progressRecords = false;
  const auto write = [&](schema::Record::Reader record) -> Status {
    if (record.isResult()) {
      run.timing.steps = double(record.getResult().getSteps());
      run.timing.rounds = double(record.getResult().getRounds());
    }
    return {};
  };
  Result<solve::QueryAnswer> answer = makeError("not asked");
  run.timing.seconds = secondsOf([&] {
    answer = [&]() -> Result<solve::QueryAnswer> {
      OBBY_ASSIGN(const solve::LoadedLevel level, solve::loadLevel(trial.query.level));
      return solve::solveQuery(level, trial.query.query.reader().getQuery(), options, pool,
                               {write, {}, {}});
    }();
  });
  OBBY_ASSIGN(const solve::QueryAnswer given, std::move(answer));
  if (given.stopped == solve::Stopped::interrupted) return std::optional<Run>();
  run.verdict = nameOf(given.verdict);
  run.timing.solved = given.verdict == schema::Verdict::SOLVED;
  run.threads = pool.size();
  return std::optional<Run>(std::move(run));
}

}  // namespace obby::bench
