#include "check.h"

#include "policy/shipped_policy.h"
#include "solve/methods.h"

namespace obby::tools {

namespace {

// Removes the parts of an answer that depend on the machine.
io::RecordBuilder lasting(schema::Record::Reader record) {
  io::RecordBuilder copy(record);
  if (copy.root().isResult()) copy.root().getResult().disownTiming();
  return copy;
}

}  // namespace

Result<std::optional<std::vector<io::RecordBuilder>>> checkLevel(const io::Record& level,
                                                                 schema::Query::Reader query,
                                                                 const CheckOptions& options) {
  OBBY_ASSIGN(const solve::LoadedLevel loaded, solve::loadLevel(level));
  solve::SolverOptions solver;
  solver.method = solve::findMethod("auto");
  solver.policy = &policy::shippedPolicy().network;  // as in obby-solve
  solver.progressRecords = false;
  solver.budget.seed = options.seed;
  // An unsolvable level needs only the proofs that run before the search.
  solver.budget.maxSteps = options.unsolvable ? 1 : options.steps;
  solver.budget.attempts = 0;
  solver.budget.stop = options.stop;
  std::vector<io::RecordBuilder> answer;
  solve::SolverOutput output;
  output.write = [&answer](schema::Record::Reader record) -> Status {
    answer.push_back(lasting(record));
    return {};
  };
  ThreadPool alone(1);
  OBBY_ASSIGN(const solve::QueryAnswer verdict,
              solve::solveQuery(loaded, query, solver, {alone}, output));
  const auto wanted = options.unsolvable ? schema::Verdict::UNREACHABLE : schema::Verdict::SOLVED;
  if (verdict.verdict != wanted) return std::optional<std::vector<io::RecordBuilder>>();
  return std::optional(std::move(answer));
}

}  // namespace obby::tools
