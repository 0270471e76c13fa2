// OMPL's SST (stable sparse RRT), an anytime planner for systems with dynamics, on our problems:
// it plays in our simulator and minimises the time to the goal.
#pragma once

#include <memory>
#include <optional>

#include "solve/model/problem.h"

namespace obby::bench {

// The defaults gave the shortest times on ten queries (docs/improvement.md).
struct SstSettings {
  double selectionRadius = 12, pruningRadius = 2.5;  // studs (PlaySpace)
  double goalBias = 0.1;
  unsigned minTicks = 1, maxTicks = 40;  // that keys are held
};

class SstPlanner {
 public:
  // The problem must outlive the planner.
  SstPlanner(const solve::Problem& problem, const SstSettings& settings, uint64_t seed);
  ~SstPlanner();
  SstPlanner(const SstPlanner&) = delete;
  SstPlanner& operator=(const SstPlanner&) = delete;

  // Goes on until `ticks` have been simulated since the start. Returns the actions of the fastest
  // solution so far, which may go on beyond the goal.
  std::optional<solve::ActionRuns> run(uint64_t ticks);

  double firstSeconds() const;  // wall-clock time from the start to the first solution
  double seconds() const;       // wall-clock time since the start

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace obby::bench
