#include "solve/report/relaxation/explain.h"

#include <algorithm>
#include <bit>

#include "base/stopwatch.h"
#include "solve/report/relaxation/relaxations.h"

namespace obby::solve {

namespace {

// Steps of all searches together: some seconds, since a person waits for the answer.
constexpr uint64_t kMaxSteps = 32'000'000;
constexpr uint64_t kFirstSteps = 128 << 10;  // budget of the first search with a change
constexpr uint64_t kStepsGrow = 4;
// A search for a smaller amount may take this many times the steps of the first solution.
constexpr uint64_t kHarder = 32;
constexpr uint64_t kMinRefineSteps = 1 << 20;

// A change, and the results of its searches so far.
struct Trial {
  Change change;
  bool hopeless = false;  // excluded by the bound on reach, or invalid
  uint32_t helps = 0;     // notches with which it is solvable; 0: none known
  uint64_t steps = 0;     // steps to the solution with those notches
};

enum class Answer { solved, failed, impossible };

class Explanation {
 public:
  Explanation(const Failure& failure, const Method& method, const Budget& budget,
              const Machine& machine)
      : posed_(failure.posed),
        method_(method),
        budget_(budget),
        machine_(machine),
        left_(std::min(budget.maxSteps, kMaxSteps)) {
    for (Change& change : changesFor(failure)) trials_.push_back({std::move(change)});
  }

  std::vector<Relaxation> run() {
    screen();
    refineAll();
    return ranked();
  }

 private:
  double secondsLeft() const { return budget_.seconds - watch_.seconds(); }
  bool over() const {
    const bool stopped = budget_.stop != nullptr && budget_.stop->load();
    return stopped || left_ == 0 || !(secondsLeft() > 0);
  }

  // Finds out which changes help at all. Short searches of all changes come before longer ones. All
  // of them together use at most half of the steps.
  void screen() {
    const uint64_t kept = left_ / 2;
    for (uint64_t steps = kFirstSteps;; steps *= kStepsGrow) {
      uint64_t ahead = 0;  // searches left in this turn
      for (const Trial& t : trials_) ahead += t.hopeless ? 0 : t.change.first.size();
      if (ahead == 0) return;
      for (Trial& t : trials_) {
        if (over() || left_ <= kept) return;
        if (t.hopeless) continue;
        tryFirst(t, std::min(steps, (left_ - kept) / ahead));
        ahead -= t.change.first.size();
      }
      const auto helps = [](const Trial& t) { return t.helps != 0; };
      if (std::any_of(trials_.begin(), trials_.end(), helps)) return;
    }
  }

  void tryFirst(Trial& t, uint64_t steps) {
    bool possible = false;
    for (const uint32_t notches : t.change.first) {
      if (over()) return;
      const Answer answer = search(t, notches, steps);
      if (answer == Answer::solved) return;
      possible |= answer == Answer::failed;
    }
    t.hopeless = !possible;
  }

  // Changes that were solved in few steps come first, and leave their remaining steps to the
  // others.
  void refineAll() {
    std::vector<Trial*> some;
    for (Trial& t : trials_) {
      if (t.helps != 0 && t.helps != kOff) some.push_back(&t);
    }
    std::stable_sort(some.begin(), some.end(),
                     [](const Trial* a, const Trial* b) { return a->steps < b->steps; });
    for (size_t i = 0; i < some.size() && !over(); ++i) refine(*some[i], left_ / (some.size() - i));
  }

  // Bisects between an amount that does not help and one that does.
  void refine(Trial& t, uint64_t share) {
    uint32_t low = 0;
    // The amount that tighten() finds may be below one whose search failed.
    while (t.helps > low + 1 && !over()) {
      const uint64_t searches = uint64_t(std::bit_width(t.helps - low - 1));
      const uint64_t steps =
          std::min(share / searches, std::max(kHarder * t.steps, kMinRefineSteps));
      const uint32_t middle = low + (t.helps - low) / 2;
      const uint64_t before = left_;
      if (search(t, middle, steps) != Answer::solved) low = middle;
      share -= std::min(share, before - left_);
    }
  }

  // Searches with the change. On success it updates the trial.
  Answer search(Trial& t, uint32_t notches, uint64_t steps) {
    const auto relaxed = RelaxedQuery::make(posed_, t.change, notches);
    if (!relaxed) return Answer::impossible;
    const PosedQuery posed = relaxed->posed();
    const Problem problem = problemOf(posed);
    if (isCut(problem, posed.queryRecord)) return Answer::impossible;
    Budget budget = budget_;
    budget.seconds = std::max(secondsLeft(), 0.0);
    budget.maxSteps = std::max(std::min(steps, left_), uint64_t(1));
    budget.solutions = 1;
    budget.attempts = 0;
    const Watcher watcher{[&](const Trajectory& p) { return solves(p, posed); }, {}};
    const SearchOutcome found = method_.run(problem, budget, watcher, machine_);
    left_ -= std::min(left_, found.statistics.steps);
    if (found.solutions.empty()) return Answer::failed;
    t.helps = notches;
    t.steps = found.statistics.steps;
    tighten(t, found.solutions.front());
    return Answer::solved;
  }

  // The trajectory may need less than the change allows.
  void tighten(Trial& t, const Trajectory& p) const {
    if (!t.change.enough) return;
    const uint32_t enough = t.change.enough(p);
    if (enough >= t.helps) return;
    const auto relaxed = RelaxedQuery::make(posed_, t.change, enough);
    if (relaxed && solves(p, relaxed->posed())) t.helps = enough;
  }

  std::vector<Relaxation> ranked() const {
    std::vector<const Trial*> found;
    for (const Trial& t : trials_) {
      if (t.helps != 0) found.push_back(&t);
    }
    std::stable_sort(found.begin(), found.end(), [](const Trial* a, const Trial* b) {
      return a->change.size(a->helps) < b->change.size(b->helps);
    });
    std::vector<Relaxation> all;
    for (const Trial* t : found) {
      const Change& c = t->change;
      all.push_back(
          {c.kind, c.amount(t->helps), c.part, c.avoid, c.field, t->steps, c.text(t->helps)});
    }
    return all;
  }

  const Stopwatch watch_;
  const PosedQuery& posed_;
  const Method& method_;
  const Budget budget_;
  const Machine machine_;
  uint64_t left_;  // steps left
  std::vector<Trial> trials_;
};

}  // namespace

std::vector<Relaxation> explain(const Failure& failure, const Method& method, const Budget& budget,
                                const Machine& machine) {
  return Explanation(failure, method, budget, machine).run();
}

}  // namespace obby::solve
