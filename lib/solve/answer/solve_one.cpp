#include "solve/answer/solve_one.h"

#include <algorithm>
#include <optional>

#include "base/stopwatch.h"
#include "solve/answer/cautious.h"
#include "solve/answer/improve_answer.h"
#include "solve/report/answer_records.h"
#include "solve/report/difficulty/difficulty_records.h"
#include "solve/report/relaxation/relaxation_records.h"
#include "solve/search/archive/heat_map.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {

namespace {

constexpr double kFirstProgress = 0.05;  // seconds to the first progress record
constexpr double kProgressEvery = 0.25;

// Answers one query for one player.
class Solving {
 public:
  Solving(const PlayerQuestion& question, const SolverOptions& options, const SolverOutput& output,
          const level::Query& compiled)
      : question_(question),
        level_(question.level),
        query_(question.query),
        options_(options),
        output_(output),
        posed_{level_.level, levelRecord(), compiled, query_, options.policy},
        identity_{compiled.id(),        level_.level.name(),    compiled.start(),
                  options.method->name, compiled.view().tricks, question.player} {}

  Result<QueryAnswer> run(const Machine& machine) {
    Problem problem = problemOf(posed_);
    problem.known = warmStarts();
    const bool earlier = !problem.known.empty();
    problem.companions = question_.companions;
    problem.known.insert(problem.known.end(), question_.hints.begin(), question_.hints.end());
    const Watcher watcher{[this](const Trajectory& p) { return accepts(p) && showFirst(p); },
                          [this](const SearchView& v) { return look(v); }};
    SearchOutcome outcome = answer(problem, watcher, machine);
    OBBY_RETURN_IF_ERROR(weighDoubts(problem, machine, outcome));
    improveSolutions(problem, machine, outcome);
    if (!earlier) outcome.knownSolutions = 0;
    if (!outcome.device && output_.deviceFailed) output_.deviceFailed(outcome.device.error());
    OBBY_RETURN_IF_ERROR(std::move(status_));
    OBBY_RETURN_IF_ERROR(
        writeAnswer(problem, outcome, explanation(outcome, machine), machine.pool));
    return QueryAnswer{verdictOf(outcome), outcome.stopped};
  }

 private:
  std::vector<ActionRuns> warmStarts() const {
    if (options_.earlier == nullptr) return {};
    const uint32_t rate = level_.level.view().params.controlRate;
    const uint32_t levelRate = question_.levelRate != 0 ? question_.levelRate : rate;
    return options_.earlier->trajectoriesOf(identity_.level, identity_.query,
                                            {question_.player, rate, levelRate});
  }

  bool accepts(const Trajectory& p) const {
    return solves(p, posed_) && (!question_.accept || question_.accept(p));
  }

  // Writes the first solution at once if it will be improved. Returns true.
  bool showFirst(const Trajectory& p) {
    const bool improves = options_.preference != nullptr && options_.improveSteps > 0;
    if (shown_ || !improves || !options_.progressRecords) return true;
    shown_ = true;
    io::RecordBuilder record;
    fillFirstSolution(record.root().initProgress(), identity_, p, watch_.seconds(), options_.paths);
    status_ = output_.write(record.reader());
    return true;
  }

  schema::Level::Reader levelRecord() const { return level_.record.reader().getLevel(); }

  // Finds the doubtful parts that the first solution touches, and prefers solutions that touch
  // none.
  Status weighDoubts(const Problem& problem, const Machine& machine, SearchOutcome& outcome) {
    if (outcome.solutions.empty() || doubtful_.empty()) return {};
    const Course course = courseOf(problem, outcome.solutions.front());
    touched_ = touchedOf(doubtful_, problem.level, course);
    if (touched_.empty() || !problem.companions.empty()) return {};
    const Watcher watcher{
        [this](const Trajectory& p) { return accepts(p); },
        [this](const SearchView&) { return !question_.goOn || question_.goOn(); }};
    OBBY_ASSIGN(avoiding_, avoidDoubts({level_, query_, problem, doubtful_, options_, watcher},
                                       machine, course, touched_, outcome));
    return {};
  }

  // Improves the solutions. None of them may touch further doubtful parts.
  void improveSolutions(const Problem& problem, const Machine& machine, SearchOutcome& outcome) {
    const auto known = [&](uint32_t part) {
      return std::ranges::find(touched_, part) != touched_.end();
    };
    const auto accept = [&](const Trajectory& p) {
      if (!accepts(p)) return false;
      if (doubtful_.empty()) return true;  // the course costs a replay
      return std::ranges::all_of(touchedOf(doubtful_, problem.level, courseOf(problem, p)), known);
    };
    const auto stop = [this] { return question_.goOn && !question_.goOn(); };
    improveAnswer({problem, options_, machine, accept, stop}, outcome);
  }

  // Skips the search if the query is proved unreachable. Nothing can be proved if the level lacks
  // parts of the place that might carry a player.
  SearchOutcome answer(const Problem& problem, const Watcher& watcher, const Machine& machine) {
    const Stopwatch watch;
    auto cut = mayBeEasier(levelRecord()) ? std::nullopt : cutOf(problem, query_);
    if (cut) {
      tryTricks(*cut, problem, query_);
      SearchOutcome shown;
      shown.stopped = Stopped::shown;
      shown.cut = std::move(cut);
      shown.seconds = watch.seconds();
      return shown;
    }
    return options_.method->run(problem, options_.budget, watcher, machine);
  }

  // Returns nullopt if no explanation is wanted or needed, or if the search was interrupted.
  std::optional<std::vector<Relaxation>> explanation(const SearchOutcome& outcome,
                                                     const Machine& machine) const {
    const bool wanted = options_.explain && outcome.solutions.empty();
    if (!wanted || outcome.stopped == Stopped::interrupted) return std::nullopt;
    const Budget& budget = options_.budget;
    auto found = explain({posed_, outcome, footprints_}, *options_.method, budget, machine);
    const bool interrupted = budget.stop != nullptr && budget.stop->load();
    if (interrupted && found.empty()) return std::nullopt;
    return found;
  }

  // Returns false to end the search. A failed write of progress ends it, since the answer could not
  // be written either.
  bool look(const SearchView& view) {
    if (question_.goOn && !question_.goOn()) return false;
    if (options_.explain || options_.heatMap) noteNewCells(view.search);
    if (view.seconds < nextProgress_) return true;
    nextProgress_ = view.seconds + kProgressEvery;
    const Statistics& s = view.search.statistics();
    if (output_.progress) {
      const Budget& b = options_.budget;
      const double spent = std::max(view.seconds / b.seconds, double(s.steps) / double(b.maxSteps));
      output_.progress({identity_.query, std::min(spent, 1.0), s.steps, view.search.cellCount(),
                        s.closest.distance});
    }
    if (!options_.progressRecords) return true;
    io::RecordBuilder record;
    fillProgress(record.root().initProgress(), identity_, view, options_.paths);
    if (status_) status_ = output_.write(record.reader());
    return bool(status_);
  }

  void noteNewCells(const Search& search) {
    const std::vector<Vec3> places = search.places(noted_);
    noted_ += uint32_t(places.size());
    if (options_.explain) footprints_.note(places);
    if (options_.heatMap) heatMap_.note(places);
  }

  Status writeAnswer(const Problem& problem, const SearchOutcome& outcome,
                     const std::optional<std::vector<Relaxation>>& relaxations, ThreadPool& pool) {
    uint32_t index = 0;
    std::string hardest;  // text about the first solution
    for (const Trajectory& p : outcome.solutions) {
      io::RecordBuilder record;
      auto trajectory = record.root().initTrajectory();
      writeTrajectory(trajectory, p, index++);
      const std::string text = fillChecked(trajectory, problem, p, pool);
      if (index == 1) hardest = text;
      OBBY_RETURN_IF_ERROR(output_.write(record.reader()));
    }
    for (const Trajectory& p : outcome.attempts) {
      io::RecordBuilder record;
      writeTrajectory(record.root().initTrajectory(), p, index++);
      OBBY_RETURN_IF_ERROR(output_.write(record.reader()));
    }
    io::RecordBuilder record;
    auto result = record.root().initResult();
    fillResult(result, identity_, outcome, level_.level, levelRecord(), query_);
    if (!outcome.solutions.empty()) fillDoubts(result, levelRecord(), touched_, avoiding_);
    if (relaxations) fillRelaxations(result, *relaxations);
    if (!hardest.empty()) result.setReason(result.getReason().cStr() + (" " + hardest));
    if (!heatMap_.empty()) heatMap_.fill(result.initHeatMap());
    result.getTiming().setCompile(float(level_.compileSeconds));
    result.setSeed(options_.budget.seed);
    return output_.write(record.reader());
  }

  void writeTrajectory(schema::Trajectory::Builder record, const Trajectory& p,
                       uint32_t index) const {
    fillTrajectory(record, identity_, p, index);
    if (options_.paths) fillPath(record, p);
  }

  // Fills in the fields that only solutions have: the route and, if asked for, the difficulty.
  // Returns a sentence about the hardest step, or an empty string.
  std::string fillChecked(schema::Trajectory::Builder record, const Problem& problem,
                          const Trajectory& p, ThreadPool& pool) const {
    const Course course = courseOf(problem, p);
    fillRoute(record, routeOf(course));
    fillDoubtful(record, touchedOf(doubtful_, problem.level, course));
    const Budget& b = options_.budget;
    const auto interrupted = [&] { return b.stop != nullptr && b.stop->load(); };
    if (options_.difficultyTrials == 0 || course.ticks() == 0 || interrupted()) return {};
    const DifficultyOptions asked{options_.difficultyTrials, b.seed, {}, b.stop};
    const Difficulty difficulty = difficultyOf(problem, course, asked, pool);
    if (interrupted()) return {};
    fillDifficulty(record.initDifficulty(), difficulty, asked.noise);
    return hardestText(difficulty, level_.level, levelRecord());
  }

  const PlayerQuestion& question_;
  const LoadedLevel& level_;
  const schema::Query::Reader query_;
  const SolverOptions& options_;
  const SolverOutput& output_;
  const PosedQuery posed_;
  const AnswerIdentity identity_;
  const std::vector<uint32_t> doubtful_ = doubtfulParts(levelRecord());
  std::vector<uint32_t> touched_;  // doubtful parts of the first solution
  Avoiding avoiding_ = Avoiding::notTried;
  uint32_t noted_ = 0;  // cells of the search noted so far
  Footprints footprints_;
  HeatMap heatMap_;
  const Stopwatch watch_;
  bool shown_ = false;  // the first solution has been written
  double nextProgress_ = kFirstProgress;
  Status status_;
};

}  // namespace

Result<QueryAnswer> solveFor(const PlayerQuestion& question, const SolverOptions& options,
                             const Machine& machine, const SolverOutput& output) {
  OBBY_ASSIGN(const level::Query compiled,
              level::Query::compile(question.query, question.level.level));
  return Solving(question, options, output, compiled).run(machine);
}

}  // namespace obby::solve
