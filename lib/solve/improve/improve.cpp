#include "solve/improve/improve.h"

#include <algorithm>

#include "solve/improve/press_risk.h"
#include "solve/improve/tighter_search.h"
#include "solve/improve/variations.h"

namespace obby::solve {

namespace {

constexpr uint32_t kRounds = 4;  // searches within tighter limits
constexpr uint32_t kBatch = 24;  // variations that are tried together
constexpr float kAround = 20;    // studs around the first solution in which hazards count

Box spaceAround(const Trajectory& p) {
  Box box{p.path.front(), p.path.front()};
  for (const Vec3& feet : p.path) box = {min(box.lo, feet), max(box.hi, feet)};
  const Vec3 around{kAround, kAround, kAround};
  return {box.lo - around, box.hi + around};
}

// A solution that gets cheaper.
class Improving {
 public:
  Improving(const ImproveTask& task, const CostMeter& meter, const Trajectory& solution,
            uint64_t stream)
      : task_(task),
        meter_(meter),
        trials_(task.problem, meter_),
        risk_(task.problem),
        random_(task.seed, stream),
        context_{task.problem.hasClock,
                 task.problem.level.params.walkSpeed / task.problem.level.params.controlRate} {
    line_ = play(actionsOf(solution));
  }

  const Line& line() const { return line_; }
  double cost() const { return line_.cost() + line_.risk; }
  uint64_t steps() const { return trials_.steps() + risk_.steps() + replayed_; }

  // Take over another solution if it is cheaper.
  void offer(const Line& other) {
    if (other.cost() + other.risk < cost()) line_ = other;
  }
  void offer(const Trajectory& other) { offer(play(actionsOf(other))); }

  // Varies the line until `budget` more ticks are spent.
  void run(uint64_t budget) {
    const uint64_t end = steps() + budget;
    if (line_.ticks() == 0) return;
    take(sweep(line_, context_));
    while (steps() < end && !stopped()) {
      std::vector<Variation> variations;
      for (uint32_t i = 0; i < kBatch; ++i)
        variations.push_back(drawVariation(line_, context_, random_));
      take(variations);
    }
  }

 private:
  bool stopped() const { return task_.stop && task_.stop(); }

  Line play(const std::vector<sim::Action>& actions) {
    replayed_ += actions.size();
    Line line = playLine(task_.problem, actions, meter_);
    const float price = task_.preference.weights.press;
    if (price > 0) line.risk = double(price) * risk_.missed(line);
    return line;
  }

  // Replaces the line by the cheapest variation that is accepted.
  void take(const std::vector<Variation>& variations) {
    for (const auto& actions : trials_.cheaper(line_, variations)) {
      Line line = play(actions);
      if (line.cost() + line.risk >= cost() || !task_.accept(trajectoryOf(line))) continue;
      line_ = std::move(line);
      return;
    }
  }

  const ImproveTask& task_;
  const CostMeter& meter_;
  VariationTrials trials_;
  PressRisk risk_;
  Random random_;
  const VariationContext context_;
  Line line_;
  uint64_t replayed_ = 0;  // ticks
};

// Improves one solution with all means: in rounds of a search within tighter limits and of
// variations.
class WideImproving {
 public:
  WideImproving(const ImproveTask& task, const Trajectory& solution, const Method& method,
                const Machine& machine)
      : task_(task),
        meter_(task.problem, task.preference.weights, spaceAround(solution)),
        search_(task.problem, method, machine, task.stop),
        best_(task, meter_, solution, 1),
        tooFewJumps_(task.problem.query.minJumps - 1) {}

  Improved run() {
    best_.run(task_.steps * 3 / 10);
    for (uint32_t round = 0; round < kRounds && steps() < task_.steps && !stopped(); ++round)
      searchAgain(round);
    if (steps() < task_.steps) best_.run(task_.steps - steps());
    return {trajectoryOf(best_.line()), best_.cost(), steps()};
  }

 private:
  uint64_t steps() const { return best_.steps() + search_.steps() + others_; }
  bool stopped() const { return task_.stop && task_.stop(); }

  void searchAgain(uint32_t round) {
    const int64_t ticks = best_.line().ticks();
    switch (round) {
      case 0: return fewerJumps();
      case 1: return fewerJumps();
      case 2: return void(searchWhole({-1, ticks * 9 / 10}, round));
      default: return void(searchWhole({}, round));
    }
  }

  // Searches with half as many jumps above the number that was too few.
  void fewerJumps() {
    const int32_t jumps = best_.line().worlds.back().jumps;
    if (jumps <= tooFewJumps_ + 1) return;
    const int32_t limit =
        tooFewJumps_ < task_.problem.query.minJumps ? tooFewJumps_ + 1 : (tooFewJumps_ + jumps) / 2;
    if (!searchWhole({limit, -1}, 0)) tooFewJumps_ = limit;
  }

  bool searchWhole(const TighterLimits& limits, uint32_t round) {
    const auto found = search_.run(limits, task_.steps / 12, task_.seed + 1, task_.accept);
    if (found.empty()) return false;
    Improving other(task_, meter_, found.front(), 2 + round);
    for (const Trajectory& p : found) other.offer(p);
    other.run(task_.steps / 16);
    others_ += other.steps();
    best_.offer(other.line());
    return true;
  }

  const ImproveTask& task_;
  const CostMeter meter_;
  TighterSearch search_;
  Improving best_;
  int32_t tooFewJumps_;
  uint64_t others_ = 0;  // ticks spent on solutions other than the best
};

}  // namespace

Improved improve(const ImproveTask& task, const Trajectory& solution) {
  const CostMeter meter(task.problem, task.preference.weights, spaceAround(solution));
  Improving improving(task, meter, solution, 0);
  improving.run(task.steps);
  return {trajectoryOf(improving.line()), improving.cost(), improving.steps()};
}

Improved improveWidely(const ImproveTask& task, const Trajectory& solution, const Method& method,
                       const Machine& machine) {
  return WideImproving(task, solution, method, machine).run();
}

}  // namespace obby::solve
