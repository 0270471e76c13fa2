#include "solve/players/players_run.h"

#include "solve/answer/solve_one.h"

namespace obby::solve {

Status PlayersRun::solve(PlayerCase& c, const SolverOptions& options, const PlayerQuestion& asked) {
  c.solutions.clear();
  c.attempts.clear();
  const auto write = [&](schema::Record::Reader record) -> Status {
    if (record.isProgress()) return output_.write(record);
    io::RecordBuilder copy(record);
    if (record.isResult()) {
      c.result = io::Record(std::move(copy));
    } else {
      const bool solves = record.getTrajectory().getOutcome() == schema::Outcome::GOAL;
      (solves ? c.solutions : c.attempts).push_back(io::Record(std::move(copy)));
    }
    return {};
  };
  OBBY_ASSIGN(const QueryAnswer answer,
              solveFor(asked, options, machine_, {write, output_.progress, output_.deviceFailed}));
  c.stopped = answer.stopped;
  steps_ += c.answer().getSteps();
  return {};
}

}  // namespace obby::solve
