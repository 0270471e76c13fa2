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

Run plannedRun(const Question& question, uint64_t program) {
  Run run;
  run.method = question.method.name;
  run.file = question.query.file;
  run.query = question.query.id;
  run.expected = question.query.expected;
  run.seed = question.seed;
  run.cap = question.cap;
  run.content = question.query.content;
  run.program = program;
  return run;
}

Result<std::optional<Run>> ask(const Question& question, Run run, ThreadPool& pool,
                               const std::atomic<bool>& stop) {
  solve::SolverOptions options;
  options.budget.seed = question.seed;
  options.budget.seconds = question.cap;
  options.budget.stop = &stop;
  options.method = &question.method;
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
      OBBY_ASSIGN(const solve::LoadedLevel level, solve::loadLevel(question.query.level));
      return solve::solveQuery(level, question.query.query.reader().getQuery(), options, pool,
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
