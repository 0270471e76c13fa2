#include "solve/answer/improve_answer.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "solve/improve/improve.h"
#include "solve/model/route.h"

namespace obby::solve {

namespace {

constexpr uint64_t kImproveSeed = 0x517cc1b727220a95u;  // differs from the search's

ImproveTask taskOf(const AnswerToImprove& answer, const SearchOutcome& outcome,
                   std::function<bool()> stop) {
  const Budget& budget = answer.options.budget;
  const uint64_t left = budget.maxSteps - std::min(budget.maxSteps, outcome.statistics.steps);
  return {answer.problem,
          *answer.options.preference,
          std::min(answer.options.improveSteps, left),
          budget.seed ^ kImproveSeed,
          answer.accept,
          std::move(stop)};
}

// Improves each solution along its own route.
uint64_t improveEach(const AnswerToImprove& answer, ImproveTask task, SearchOutcome& outcome) {
  std::vector<Improved> done;
  const uint64_t share = task.steps / outcome.solutions.size();
  uint64_t steps = 0;
  for (const Trajectory& p : outcome.solutions) {
    const auto route = directRouteOf(answer.problem, courseOf(answer.problem, p));
    task.steps = share;
    task.accept = [&](const Trajectory& q) {
      const auto differs = [&](const Improved& other) {
        return pathsDiffer(q.path, other.trajectory.path, kDistinct);
      };
      return (outcome.diverse || std::ranges::all_of(done, differs)) && answer.accept(q) &&
             directRouteOf(answer.problem, courseOf(answer.problem, q)) == route;
    };
    done.push_back(improve(task, p));
    steps += done.back().steps;
  }
  // Pointers are sorted, since the buffer of stable_sort ignores the alignment of sim::World.
  std::vector<Improved*> order;
  for (Improved& d : done) order.push_back(&d);
  std::ranges::stable_sort(order, {}, &Improved::cost);
  std::ranges::transform(order, outcome.solutions.begin(),
                         [](Improved* d) { return std::move(d->trajectory); });
  return steps;
}

}  // namespace

void improveAnswer(const AnswerToImprove& answer, SearchOutcome& outcome) {
  const SolverOptions& options = answer.options;
  if (outcome.solutions.empty() || options.preference == nullptr || options.improveSteps == 0)
    return;
  const Stopwatch watch;
  const Budget& budget = options.budget;
  const double left = budget.seconds - outcome.seconds;
  const auto stop = [&] {
    return (budget.stop != nullptr && budget.stop->load()) || watch.seconds() >= left ||
           answer.stop();
  };
  const ImproveTask task = taskOf(answer, outcome, stop);
  if (task.steps == 0) return;
  if (outcome.solutions.size() > 1) {
    outcome.statistics.steps += improveEach(answer, task, outcome);
  } else {
    Improved best = improveWidely(task, outcome.solutions.front(), *options.method, answer.machine);
    outcome.solutions.front() = std::move(best.trajectory);
    outcome.statistics.steps += best.steps;
  }
  outcome.seconds += watch.seconds();
}

}  // namespace obby::solve
