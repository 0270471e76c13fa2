// Searches again for better solutions, within tighter limits.
#pragma once

#include <functional>
#include <vector>

#include "solve/search/method.h"

namespace obby::solve {

// Limits of a search; -1: as the query has it.
struct TighterLimits {
  int32_t jumps = -1;
  int64_t ticks = -1;
};

class TighterSearch {
 public:
  // All must outlive the search. `stop` may be empty.
  TighterSearch(const Problem& problem, const Method& method, const Machine& machine,
                const std::function<bool()>& stop)
      : problem_(problem), method_(method), machine_(machine), stop_(stop) {}

  // Returns up to kTaken distinct solutions within the limits that `accept` accepts.
  std::vector<Trajectory> run(const TighterLimits& limits, uint64_t maxSteps, uint64_t seed,
                              const std::function<bool(const Trajectory&)>& accept);
  static constexpr uint32_t kTaken = 3;

  uint64_t steps() const { return steps_; }  // simulated ticks

 private:
  const Problem& problem_;
  const Method& method_;
  const Machine& machine_;
  const std::function<bool()>& stop_;
  uint64_t steps_ = 0;
};

}  // namespace obby::solve
