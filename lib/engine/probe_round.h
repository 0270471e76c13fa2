// All probes of one moment, and second looks at parts that harm. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/child.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

// Share of the whole time limit: one copy of the place that hangs must leave time for the others.
constexpr double kCopyShare = 0.25;

class ProbeRound {
 public:
  ProbeRound(Stage& stage, const Plan& plan, Children& children)
      : stage_(stage), plan_(plan), children_(children), limit_(plan.timeLimit * kCopyShare) {}

  // Each probe runs in a copy of the place as it is now.
  std::vector<Probe> run(std::vector<Probe> wanted);

 private:
  void runAll(const std::vector<Probe>& wanted);
  void lookAgainAtHarm(const std::vector<Probe>& wanted);
  void lookAllOver(const Probe& wanted, size_t index);
  void lookFromOutside(const Probe& wanted, size_t index);

  Stage& stage_;
  const Plan& plan_;
  Children& children_;
  double limit_;  // seconds of the wall clock, for one copy
  std::vector<Probe> probes_;
};

}  // namespace obby::engine
