#include "solve/players/solve_players.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "solve/answer/solve_one.h"
#include "solve/model/retimed.h"
#include "solve/model/route.h"
#include "solve/players/player_case.h"
#include "solve/players/player_result.h"
#include "solve/players/same_keys.h"
#include "solve/report/answer_records.h"

namespace obby::solve {

namespace {

// A method that does not search. It is used if only the bound is needed.
SearchOutcome noSearch(const Problem&, const Budget&, const Watcher&, const Machine&) {
  SearchOutcome outcome;
  outcome.stopped = Stopped::outOfSteps;
  return outcome;
}
constexpr Method kNoSearch{"bound", "no search", noSearch};

// Number of solutions that other players may refuse before the search restarts with another seed.
// It doubles each time. Methods that ignore companions need this: their cells keep the earliest
// trajectory, so a search would be stuck with a first jump that fails for another player.
constexpr uint32_t kFirstRefusals = 48;
constexpr uint64_t kSeedStep = 0x9e3779b97f4a7c15u;

class PlayersSolving {
 public:
  PlayersSolving(const LoadedLevel& level, schema::Query::Reader query,
                 const SolverOptions& options, const Machine& machine, const SolverOutput& output,
                 std::vector<PlayerCase> cases)
      : level_(level),
        query_(query),
        options_(options),
        machine_(machine),
        output_(output),
        cases_(std::move(cases)) {}

  Result<QueryAnswer> run() {
    const bool together = query_.getSameKeys() && cases_.size() > 1;
    OBBY_RETURN_IF_ERROR(together ? solveTogether() : solveEach());
    OBBY_RETURN_IF_ERROR(writeTrajectories());
    const PlayersAsked asked{rate(), query_.getBodies().size() > 0, together};
    const io::Record result = resultOf(cases_, asked);
    OBBY_RETURN_IF_ERROR(output_.write(result.reader()));
    return QueryAnswer{verdictOf(cases_), stopped()};
  }

 private:
  uint16_t rate() const { return level_.level.view().params.controlRate; }

  // Each player gets an equal share of the budget that is left.
  Status solveEach() {
    for (size_t i = 0; i < cases_.size(); ++i) {
      SolverOptions options = options_;
      options.budget.seconds = secondsLeft() / double(cases_.size() - i);
      options.budget.maxSteps = stepsLeft() / (cases_.size() - i);
      options.improveSteps = options_.improveSteps / cases_.size();
      // A change that helps one player is enough.
      options.explain = options_.explain && !explained_;
      OBBY_RETURN_IF_ERROR(solve(cases_[i], options,
                                 {*cases_[i].level, cases_[i].queryRecord(), cases_[i].player,
                                  rate(), hintsFor(cases_[i])}));
      explained_ |= cases_[i].answer().getVerdict() != schema::Verdict::SOLVED;
    }
    return {};
  }

  // Returns the first solution of each earlier player in the list, converted to this player's rate.
  std::vector<ActionRuns> hintsFor(const PlayerCase& c) const {
    std::vector<ActionRuns> hints;
    for (const PlayerCase& other : cases_) {
      if (&other == &c) break;
      if (other.solutions.empty()) continue;
      const auto plan = sim::planFromRecord(other.solutions.front().reader().getTrajectory());
      if (plan) hints.push_back(retimed(plan->actions, other.rate, c.rate));
    }
    return hints;
  }

  // Tries the bound for each player first. Then the slowest player searches for all.
  Status solveTogether() {
    for (PlayerCase& c : cases_) {
      SolverOptions options = options_;
      options.method = &kNoSearch;
      options.explain = options.heatMap = false;
      options.budget.attempts = 0;
      const EarlierAnswers none;
      options.earlier = &none;
      OBBY_RETURN_IF_ERROR(solve(c, options, question(c)));
    }
    if (verdictOf(cases_) == schema::Verdict::UNREACHABLE) return {};
    PlayerCase& first = cases_[slowest(cases_)];
    std::vector<KeyPlayer> others;
    for (const PlayerCase& c : cases_) {
      if (&c == &first) continue;
      OBBY_ASSIGN(KeyPlayer player, KeyPlayer::make(c));
      others.push_back(std::move(player));
    }
    OBBY_RETURN_IF_ERROR(searchTogether(first, others));
    return first.solutions.empty() ? Status() : giveAll(first, others);
  }

  Status searchTogether(PlayerCase& first, const std::vector<KeyPlayer>& others) {
    SolverOptions options = options_;
    uint64_t steps = 0;
    double seconds = 0;
    for (uint32_t max = kFirstRefusals;; max *= 2, options.budget.seed += kSeedStep) {
      options.budget.seconds = secondsLeft();
      options.budget.maxSteps = options_.budget.maxSteps - steps;
      uint32_t refused = 0;
      PlayerQuestion asked = question(first);
      asked.accept = [&](const Trajectory& p) {
        const bool solves = std::ranges::all_of(others, [&](const KeyPlayer& other) {
          return other.solve(p.actions, first.rate).has_value();
        });
        refused += solves ? 0 : 1;
        return solves;
      };
      for (const KeyPlayer& other : others) asked.companions.push_back(other.companion());
      asked.goOn = [&] { return refused < max; };
      OBBY_RETURN_IF_ERROR(solve(first, options, asked));
      addWork(first, steps, seconds);
      const bool startOver = first.stopped == Stopped::interrupted && refused >= max;
      if (!startOver || secondsLeft() <= 0 || steps >= options_.budget.maxSteps || interrupted())
        return {};
    }
  }

  // Adds the work of the earlier searches to the result of this one.
  static void addWork(PlayerCase& c, uint64_t& steps, double& seconds) {
    io::RecordBuilder record(c.result->reader());
    auto result = record.root().getResult();
    auto timing = result.getTiming();
    if (timing.getFirstSolution() > 0)
      timing.setFirstSolution(timing.getFirstSolution() + float(seconds));
    steps += result.getSteps();
    seconds += double(timing.getSeconds());
    result.setSteps(steps);
    timing.setSeconds(float(seconds));
    c.result = io::Record(std::move(record));
  }

  // Replays the keys of every solution for each other player, and adds the trajectories.
  Status giveAll(const PlayerCase& first, const std::vector<KeyPlayer>& others) {
    size_t at = 0;
    for (PlayerCase& c : cases_) {
      if (&c == &first) continue;
      const KeyPlayer& player = others[at++];
      io::RecordBuilder result(c.result->reader());
      auto answer = result.root().getResult();
      for (const io::Record& solution : first.solutions) {
        OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(solution.reader().getTrajectory()));
        const auto p = player.solve(plan.actions, first.rate);
        if (!p) continue;  // cannot happen: the search has checked it
        if (c.solutions.empty()) fillSolved(answer, *p, player.posed());
        c.solutions.push_back(trajectoryOf(*p, player.posed(), c.player));
      }
      c.result = io::Record(std::move(result));
      c.stopped = first.stopped;
    }
    return {};
  }

  void fillSolved(schema::Result::Builder answer, const Trajectory& p,
                  const PosedQuery& posed) const {
    SearchOutcome outcome;
    outcome.stopped = Stopped::solved;
    outcome.solutions.push_back(p);
    const AnswerIdentity identity{posed.query.id(),          posed.level.name(),
                                  posed.query.start(),       options_.method->name,
                                  posed.query.view().tricks, {}};
    fillResult(answer, identity, outcome, posed.level, posed.levelRecord, posed.queryRecord);
  }

  io::Record trajectoryOf(const Trajectory& p, const PosedQuery& posed,
                          const level::Player& player) const {
    const AnswerIdentity identity{posed.query.id(),          posed.level.name(),
                                  posed.query.start(),       options_.method->name,
                                  posed.query.view().tricks, player};
    io::RecordBuilder record;
    auto trajectory = record.root().initTrajectory();
    fillTrajectory(trajectory, identity, p, 0);
    if (options_.paths) fillPath(trajectory, p);
    fillRoute(trajectory, routeOf(courseOf(problemOf(posed), p)));
    return io::Record(std::move(record));
  }

  PlayerQuestion question(const PlayerCase& c) const {
    return {*c.level, c.queryRecord(), c.player, rate()};
  }

  // Solves one case. Writes progress at once and keeps the other records with the case.
  Status solve(PlayerCase& c, const SolverOptions& options, const PlayerQuestion& asked) {
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
    OBBY_ASSIGN(
        const QueryAnswer answer,
        solveFor(asked, options, machine_, {write, output_.progress, output_.deviceFailed}));
    c.stopped = answer.stopped;
    steps_ += c.answer().getSteps();
    return {};
  }

  // Writes all solutions, then the attempts of the first player without a solution.
  Status writeTrajectories() {
    uint32_t index = 0;
    const auto write = [&](const io::Record& trajectory) {
      io::RecordBuilder record(trajectory.reader());
      record.root().getTrajectory().setIndex(index++);
      return output_.write(record.reader());
    };
    for (const PlayerCase& c : cases_) {
      for (const io::Record& t : c.solutions) OBBY_RETURN_IF_ERROR(write(t));
    }
    const auto shown = std::ranges::find_if(
        cases_, [](const PlayerCase& c) { return c.solutions.empty() && !c.attempts.empty(); });
    const PlayerCase& from = shown == cases_.end() ? cases_.front() : *shown;
    for (const io::Record& t : from.attempts) OBBY_RETURN_IF_ERROR(write(t));
    return {};
  }

  Stopped stopped() const {
    const auto cut = std::ranges::find(cases_, Stopped::interrupted, &PlayerCase::stopped);
    return cut == cases_.end() ? cases_.front().stopped : Stopped::interrupted;
  }
  bool interrupted() const {
    return options_.budget.stop != nullptr && options_.budget.stop->load();
  }
  double secondsLeft() const { return std::max(0.0, options_.budget.seconds - watch_.seconds()); }
  uint64_t stepsLeft() const {
    return options_.budget.maxSteps - std::min(steps_, options_.budget.maxSteps);
  }

  const LoadedLevel& level_;
  const schema::Query::Reader query_;
  const SolverOptions& options_;
  const Machine& machine_;
  const SolverOutput& output_;
  std::vector<PlayerCase> cases_;
  const Stopwatch watch_;
  uint64_t steps_ = 0;
  bool explained_ = false;
};

}  // namespace

Result<QueryAnswer> solveForPlayers(const LoadedLevel& level, schema::Query::Reader query,
                                    const SolverOptions& options, const Machine& machine,
                                    const SolverOutput& output) {
  OBBY_ASSIGN(std::vector<PlayerCase> cases, playerCases(level, query));
  return PlayersSolving(level, query, options, machine, output, std::move(cases)).run();
}

}  // namespace obby::solve
