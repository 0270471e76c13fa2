#include "solve/players/together.h"

#include "solve/model/route.h"
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

// Counts the solutions of a search that other players refuse, until all accept one.
struct Refusals {
  uint32_t count = 0;
  bool over = false;
};

// The slowest player searches, and the others press its keys.
class Together {
 public:
  // The run must outlive this object.
  static Result<Together> make(PlayersRun& run) {
    Together together(run);
    for (const PlayerCase& c : run.cases) {
      if (&c == &together.first_) continue;
      OBBY_ASSIGN(KeyPlayer player, KeyPlayer::make(c));
      together.others_.push_back(std::move(player));
    }
    return together;
  }

  Status solve() {
    SolverOptions options = run_.options();
    const uint64_t maxSteps = options.budget.maxSteps;
    uint64_t steps = 0;
    double seconds = 0;
    for (uint32_t max = kFirstRefusals;; max *= 2, options.budget.seed += kSeedStep) {
      options.budget.seconds = run_.secondsLeft();
      options.budget.maxSteps = maxSteps - steps;
      Refusals refused;
      PlayerQuestion asked = question(refused);
      asked.goOn = [&] { return refused.count < max; };
      OBBY_RETURN_IF_ERROR(run_.solve(first_, options, asked));
      addWork(steps, seconds);
      const bool startOver = first_.stopped == Stopped::interrupted && refused.count >= max;
      if (!startOver || run_.secondsLeft() <= 0 || steps >= maxSteps || run_.interrupted()) break;
    }
    return first_.solutions.empty() ? Status() : giveAll();
  }

  Result<bool> share() {
    const SolverOptions& all = run_.options();
    SolverOptions options = all;
    options.improveSteps = all.improveSteps / 2;
    options.budget.seconds = run_.secondsLeft();
    options.budget.maxSteps = std::min(run_.stepsLeft(), all.improveSteps);
    options.budget.attempts = 0;
    options.explain = options.heatMap = options.progressRecords = false;
    const PlayerCase own = first_;
    Refusals refused;
    PlayerQuestion asked = question(refused);
    asked.goOn = [&] { return refused.count < kFirstRefusals; };
    asked.hints = firstKeys(run_.cases, first_.rate);
    OBBY_RETURN_IF_ERROR(run_.solve(first_, options, asked));
    uint64_t steps = own.answer().getSteps();
    double seconds = double(own.answer().getTiming().getSeconds());
    const bool shared = !first_.solutions.empty();
    addWork(steps, seconds);
    if (!shared) {
      first_ = own;
      return false;
    }
    first_.attempts = own.attempts;
    OBBY_RETURN_IF_ERROR(giveAll());
    return true;
  }

 private:
  explicit Together(PlayersRun& run) : run_(run), first_(run.cases[slowest(run.cases)]) {}

  // Asks the slowest player for keys that solve the query for the others, too. Counts those that
  // do not, until some do: the improvement of a solution may be refused as often as it likes.
  PlayerQuestion question(Refusals& refused) {
    PlayerQuestion asked = run_.question(first_);
    asked.accept = [&](const Trajectory& p) {
      const bool solves = std::ranges::all_of(others_, [&](const KeyPlayer& other) {
        return other.solve(p.actions, first_.rate).has_value();
      });
      refused.over |= solves;
      refused.count += refused.over ? 0 : 1;
      return solves;
    };
    for (const KeyPlayer& other : others_) asked.companions.push_back(other.companion());
    return asked;
  }

  // Adds the work of earlier searches to the slowest player's result, and that of the result to
  // `steps` and `seconds`.
  void addWork(uint64_t& steps, double& seconds) {
    io::RecordBuilder record(first_.result->reader());
    auto result = record.root().getResult();
    auto timing = result.getTiming();
    if (timing.getFirstSolution() > 0)
      timing.setFirstSolution(timing.getFirstSolution() + float(seconds));
    steps += result.getSteps();
    seconds += double(timing.getSeconds());
    result.setSteps(steps);
    timing.setSeconds(float(seconds));
    first_.result = io::Record(std::move(record));
  }

  // Replays the keys of every solution for each other player. The trajectories become its
  // solutions.
  Status giveAll() {
    for (const KeyPlayer& player : others_) {
      PlayerCase& c = *std::ranges::find_if(
          run_.cases, [&](const PlayerCase& c) { return &c == &player.playerCase(); });
      c.solutions.clear();
      io::RecordBuilder result(c.result->reader());
      auto answer = result.root().getResult();
      for (const io::Record& solution : first_.solutions) {
        OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(solution.reader().getTrajectory()));
        const auto p = player.solve(plan.actions, first_.rate);
        if (!p) continue;  // cannot happen: the search has checked it
        if (c.solutions.empty()) fillSolved(answer, *p, player.posed());
        c.solutions.push_back(trajectoryOf(*p, player.posed(), c.player));
      }
      c.result = io::Record(std::move(result));
      c.stopped = first_.stopped;
    }
    return {};
  }

  AnswerIdentity identityOf(const PosedQuery& posed, const level::Player& player) const {
    return {posed.query.id(),          posed.level.name(),
            posed.query.start(),       run_.options().method->name,
            posed.query.view().tricks, player};
  }

  void fillSolved(schema::Result::Builder answer, const Trajectory& p,
                  const PosedQuery& posed) const {
    SearchOutcome outcome;
    outcome.stopped = Stopped::solved;
    outcome.solutions.push_back(p);
    fillResult(answer, identityOf(posed, {}), outcome, posed.level, posed.levelRecord,
               posed.queryRecord);
  }

  io::Record trajectoryOf(const Trajectory& p, const PosedQuery& posed,
                          const level::Player& player) const {
    io::RecordBuilder record;
    auto trajectory = record.root().initTrajectory();
    fillTrajectory(trajectory, identityOf(posed, player), p, 0);
    if (run_.options().paths) fillPath(trajectory, p);
    fillRoute(trajectory, routeOf(courseOf(problemOf(posed), p)));
    return io::Record(std::move(record));
  }

  PlayersRun& run_;
  PlayerCase& first_;
  std::vector<KeyPlayer> others_;
};

}  // namespace

Status solveTogether(PlayersRun& run) {
  for (PlayerCase& c : run.cases) {
    SolverOptions options = run.options();
    options.method = &kNoSearch;
    options.explain = options.heatMap = false;
    options.budget.attempts = 0;
    const EarlierAnswers none;
    options.earlier = &none;
    OBBY_RETURN_IF_ERROR(run.solve(c, options, run.question(c)));
  }
  if (verdictOf(run.cases) == schema::Verdict::UNREACHABLE) return {};
  OBBY_ASSIGN(Together together, Together::make(run));
  return together.solve();
}

Result<bool> shareKeys(PlayersRun& run) {
  OBBY_ASSIGN(Together together, Together::make(run));
  return together.share();
}

}  // namespace obby::solve
