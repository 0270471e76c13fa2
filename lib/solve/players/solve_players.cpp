#include "solve/players/solve_players.h"

#include "solve/players/player_result.h"
#include "solve/players/same_keys.h"
#include "solve/players/together.h"

namespace obby::solve {

namespace {

// Each player gets an equal share of the budget that is left.
Status solveEach(PlayersRun& run) {
  bool explained = false;
  for (size_t i = 0; i < run.cases.size(); ++i) {
    PlayerCase& c = run.cases[i];
    SolverOptions options = run.options();
    options.budget.seconds = run.secondsLeft() / double(run.cases.size() - i);
    options.budget.maxSteps = run.stepsLeft() / (run.cases.size() - i);
    options.improveSteps /= run.cases.size();
    options.explain &= !explained;  // a change that helps one player is enough
    PlayerQuestion asked = run.question(c);
    asked.hints = firstKeys(std::span(run.cases).first(i), c.rate);  // of those before it
    OBBY_RETURN_IF_ERROR(run.solve(c, options, asked));
    explained |= c.answer().getVerdict() != schema::Verdict::SOLVED;
  }
  return {};
}

// Answers all cases. Returns how the keys of the solutions belong together.
Result<PlayersKeys> solveAll(PlayersRun& run, bool sameKeys) {
  if (sameKeys && run.cases.size() > 1) {
    OBBY_RETURN_IF_ERROR(solveTogether(run));
    return PlayersKeys::asked;
  }
  OBBY_RETURN_IF_ERROR(solveEach(run));
  const bool shares = run.cases.size() > 1 && run.options().improveSteps > 0 &&
                      run.options().preference != nullptr &&
                      verdictOf(run.cases) == schema::Verdict::SOLVED;
  if (!shares) return PlayersKeys::own;
  OBBY_ASSIGN(const bool shared, shareKeys(run));
  return shared ? PlayersKeys::shared : PlayersKeys::own;
}

// Writes all solutions, then the attempts of the first player without a solution.
Status writeTrajectories(const PlayersRun& run) {
  uint32_t index = 0;
  const auto write = [&](const io::Record& trajectory) {
    io::RecordBuilder record(trajectory.reader());
    record.root().getTrajectory().setIndex(index++);
    return run.output().write(record.reader());
  };
  for (const PlayerCase& c : run.cases) {
    for (const io::Record& t : c.solutions) OBBY_RETURN_IF_ERROR(write(t));
  }
  const auto shown = std::ranges::find_if(
      run.cases, [](const PlayerCase& c) { return c.solutions.empty() && !c.attempts.empty(); });
  const PlayerCase& from = shown == run.cases.end() ? run.cases.front() : *shown;
  for (const io::Record& t : from.attempts) OBBY_RETURN_IF_ERROR(write(t));
  return {};
}

Stopped stoppedOf(const PlayersRun& run) {
  const auto cut = std::ranges::find(run.cases, Stopped::interrupted, &PlayerCase::stopped);
  return cut == run.cases.end() ? run.cases.front().stopped : Stopped::interrupted;
}

}  // namespace

Result<QueryAnswer> solveForPlayers(const LoadedLevel& level, schema::Query::Reader query,
                                    const SolverOptions& options, const Machine& machine,
                                    const SolverOutput& output) {
  OBBY_ASSIGN(std::vector<PlayerCase> cases, playerCases(level, query));
  PlayersRun run(level, options, machine, output, std::move(cases));
  OBBY_ASSIGN(const PlayersKeys keys, solveAll(run, query.getSameKeys()));
  OBBY_RETURN_IF_ERROR(writeTrajectories(run));
  const PlayersAsked asked{run.rate(), query.getBodies().size() > 0, keys};
  const io::Record result = resultOf(run.cases, asked);
  OBBY_RETURN_IF_ERROR(output.write(result.reader()));
  return QueryAnswer{verdictOf(run.cases), stoppedOf(run)};
}

}  // namespace obby::solve
