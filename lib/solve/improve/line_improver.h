// Makes one solution cheaper by varying it.
#pragma once

#include <memory>

#include "solve/improve/improve_task.h"
#include "solve/improve/press_risk.h"
#include "solve/improve/variations.h"

namespace obby::solve {

class LineImprover {
 public:
  // All must outlive the improver. `donors`: other solutions, of which it may take spans. `stream`
  // tells the random numbers of improvers with one task apart.
  LineImprover(const ImproveTask& task, const CostMeter& meter, const Trajectory& solution,
               const GuidedLines& donors, uint64_t stream);

  const Line& line() const { return base_->line; }
  const std::shared_ptr<const GuidedLine>& base() const { return base_; }
  double cost() const { return priceOf(*base_); }  // seconds
  uint64_t steps() const { return pool_.steps() + risk_.steps() + replayed_; }

  // Varies the line until `budget` more ticks are simulated.
  void run(uint64_t budget);

 private:
  static double priceOf(const GuidedLine& base) { return base.line.cost() + base.line.risk; }
  std::shared_ptr<const GuidedLine> play(const std::vector<sim::Action>& actions);
  void take(const std::vector<std::vector<sim::Action>>& solutions);

  const ImproveTask& task_;
  const CostMeter& meter_;
  VariationPool pool_;
  PressRisk risk_;
  Random random_;
  const VariationContext context_;
  std::shared_ptr<const GuidedLine> base_;
  uint64_t replayed_ = 0;  // ticks
};

}  // namespace obby::solve
