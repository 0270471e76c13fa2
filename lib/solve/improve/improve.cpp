#include "solve/improve/improve.h"

#include <algorithm>

#include "solve/improve/line_improver.h"
#include "solve/improve/tighter_search.h"

namespace obby::solve {

namespace {

constexpr float kAround = 20;  // studs around the first solution in which hazards count

// Budgets, as shares of the task's.
constexpr double kFirst = 0.02;      // varying the first solution before any search
constexpr double kSearching = 0.35;  // until the last search has begun
constexpr double kOneSearch = 0.05;
constexpr double kLook = 0.015;     // varying each solution that a search finds
constexpr uint32_t kSearches = 12;  // max searches

// The cheapest `count` solutions are kept, and each is varied for `share` of the budget.
struct Halving {
  uint32_t count;
  double share;
};
constexpr Halving kHalvings[] = {{4, 0.03}, {2, 0.08}, {1, 0}};

Box spaceAround(const Trajectory& p) {
  Box box{p.path.front(), p.path.front()};
  for (const Vec3& feet : p.path) box = {min(box.lo, feet), max(box.hi, feet)};
  const Vec3 around{kAround, kAround, kAround};
  return {box.lo - around, box.hi + around};
}

// Searches for other solutions, some within tighter limits, and shares the budget among them by
// successive halving.
class WideImproving {
 public:
  WideImproving(const ImproveTask& task, const Trajectory& solution, const Method& method,
                const Machine& machine)
      : task_(task),
        meter_(task.problem, task.preference.weights, spaceAround(solution)),
        search_(task.problem, method, machine, task.stop),
        tooFewJumps_(task.problem.query.minJumps - 1) {
    add(solution);
  }

  Improved run() {
    best().run(ticksOf(kFirst));
    for (uint32_t round = 0; round < kSearches && steps() < ticksOf(kSearching); ++round) {
      if (stopped()) break;
      searchAgain(round);
    }
    for (const auto& c : candidates_) donors_.push_back(c->base());
    for (const Halving& h : kHalvings) halve(h);
    if (steps() < task_.steps) best().run(task_.steps - steps());
    return {trajectoryOf(best().line()), best().cost(), steps()};
  }

 private:
  LineImprover& best() { return *candidates_.front(); }
  bool stopped() const { return task_.stop && task_.stop(); }
  uint64_t ticksOf(double share) const { return uint64_t(double(task_.steps) * share); }

  uint64_t steps() const {
    uint64_t steps = search_.steps() + dropped_;
    for (const auto& c : candidates_) steps += c->steps();
    return steps;
  }

  LineImprover& add(const Trajectory& solution) {
    const uint64_t stream = ++added_;
    return *candidates_.emplace_back(
        std::make_unique<LineImprover>(task_, meter_, solution, donors_, stream));
  }

  void sort() {
    std::ranges::stable_sort(candidates_, {}, [](const auto& c) { return c->cost(); });
  }

  void halve(const Halving& halving) {
    while (candidates_.size() > halving.count) {
      dropped_ += candidates_.back()->steps();
      candidates_.pop_back();
    }
    if (candidates_.size() == 1) return;
    for (const auto& c : candidates_) {
      if (steps() < task_.steps) c->run(ticksOf(halving.share));
    }
    sort();
  }

  void searchAgain(uint32_t round) {
    const int64_t ticks = best().line().ticks();
    switch (round % 4) {
      case 0:
      case 2: return fewerJumps(round);
      case 1: return void(search({-1, ticks * 9 / 10}, round));
      default: return void(search({}, round));
    }
  }

  // Searches with half as many jumps above the number that was too few.
  void fewerJumps(uint32_t round) {
    const int32_t jumps = best().line().worlds.back().jumps;
    if (jumps <= tooFewJumps_ + 1) return;
    const int32_t limit =
        tooFewJumps_ < task_.problem.query.minJumps ? tooFewJumps_ + 1 : (tooFewJumps_ + jumps) / 2;
    if (!search({limit, -1}, round)) tooFewJumps_ = limit;
  }

  // Returns false if nothing was found.
  bool search(const TighterLimits& limits, uint32_t round) {
    const auto found =
        search_.run(limits, ticksOf(kOneSearch), task_.seed + 1 + round, task_.accept);
    for (const Trajectory& p : found) {
      LineImprover& candidate = add(p);
      donors_.push_back(candidate.base());
      candidate.run(ticksOf(kLook));
    }
    sort();
    return !found.empty();
  }

  const ImproveTask& task_;
  const CostMeter meter_;
  TighterSearch search_;
  GuidedLines donors_;
  std::vector<std::unique_ptr<LineImprover>> candidates_;  // the cheapest first
  int32_t tooFewJumps_;
  uint64_t added_ = 0;    // candidates so far
  uint64_t dropped_ = 0;  // ticks spent on former candidates
};

}  // namespace

Improved improve(const ImproveTask& task, const Trajectory& solution) {
  const CostMeter meter(task.problem, task.preference.weights, spaceAround(solution));
  const GuidedLines none;
  LineImprover improver(task, meter, solution, none, 0);
  improver.run(task.steps);
  return {trajectoryOf(improver.line()), improver.cost(), improver.steps()};
}

Improved improveWidely(const ImproveTask& task, const Trajectory& solution, const Method& method,
                       const Machine& machine) {
  return WideImproving(task, solution, method, machine).run();
}

}  // namespace obby::solve
