#include "solve/improve/line_improver.h"

namespace obby::solve {

LineImprover::LineImprover(const ImproveTask& task, const CostMeter& meter,
                           const Trajectory& solution, const GuidedLines& donors, uint64_t stream)
    : task_(task),
      meter_(meter),
      pool_(task.problem, meter_),
      risk_(task.problem),
      random_(task.seed, stream),
      context_{task.problem.hasClock,
               task.problem.level.params.walkSpeed / task.problem.level.params.controlRate, donors},
      base_(play(actionsOf(solution))) {
  if (line().ticks() == 0) return;
  for (Variation& variation : sweep(*base_, context_)) pool_.add(base_, std::move(variation));
}

void LineImprover::run(uint64_t budget) {
  const uint64_t end = steps() + budget;
  while (line().ticks() > 0 && steps() < end && !(task_.stop && task_.stop())) {
    while (!pool_.isFull()) pool_.add(base_, drawVariation(*base_, context_, random_));
    take(pool_.tick(line()));
  }
}

std::shared_ptr<const GuidedLine> LineImprover::play(const std::vector<sim::Action>& actions) {
  replayed_ += actions.size();
  Line line = playLine(task_.problem, actions, meter_);
  const float price = task_.preference.weights.press;
  if (price > 0) line.risk = double(price) * risk_.missed(line);
  Guide guide = guideAlong(line);
  return std::make_shared<GuidedLine>(GuidedLine{std::move(line), std::move(guide)});
}

// Takes over the first of the solutions that is cheaper and accepted.
void LineImprover::take(const std::vector<std::vector<sim::Action>>& solutions) {
  for (const auto& actions : solutions) {
    auto base = play(actions);
    if (priceOf(*base) >= cost() || !task_.accept(trajectoryOf(base->line))) continue;
    base_ = std::move(base);
    return;
  }
}

}  // namespace obby::solve
