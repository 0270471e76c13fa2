// Runs all probes of one moment, and second probes of harmful parts. Private to lib/engine.
#pragma once

#include <vector>

#include "engine/child.h"
#include "engine/probe_run.h"
#include "engine/report.h"
#include "engine/stage.h"

namespace obby::engine {

class ProbeRound {
 public:
  ProbeRound(Stage& stage, const Plan& plan, Children& children)
      : stage_(stage), plan_(plan), children_(children), limit_(plan.timeLimit * kCopyShare) {}

  // Runs each probe in a copy of the place in its current state.
  std::vector<Probe> run(std::vector<Probe> wanted);

 private:
  void runAll(const std::vector<Probe>& wanted);
  void lookAgainAtHarm(const std::vector<Probe>& wanted);
  void lookAllOver(const Probe& wanted, size_t index);
  void lookFromOutside(const Probe& wanted, size_t index);

  Stage& stage_;
  const Plan& plan_;
  Children& children_;
  double limit_;  // seconds of wall time for one copy
  std::vector<Probe> probes_;
};

}  // namespace obby::engine
