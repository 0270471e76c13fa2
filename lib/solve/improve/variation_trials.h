// Plays changed trajectories together in SIMD lanes, and returns the cheapest that reaches the
// goal.
#pragma once

#include <optional>
#include <vector>

#include "solve/improve/follower.h"
#include "solve/improve/lockstep.h"

namespace obby::solve {

// A variation of a line: keep its first `start` ticks, then follow the guide from point `start` on.
struct Variation {
  Guide guide;
  uint32_t start = 0;  // tick of the line, and point of the guide
  FollowSettings settings;
};

class VariationTrials {
 public:
  // Both must outlive the trials.
  VariationTrials(const Problem& problem, const CostMeter& meter)
      : problem_(problem), meter_(meter), lockstep_(problem) {}

  // Returns the actions of each variation that reaches the goal at a lower cost than the line, the
  // cheapest first.
  std::vector<std::vector<sim::Action>> cheaper(const Line& line,
                                                const std::vector<Variation>& variations);

  uint64_t steps() const { return lockstep_.steps(); }  // simulated ticks

 private:
  struct Member;

  bool goesOn(const Line& line, const Member& member) const;
  void tick(std::vector<Member*>& running);

  const Problem& problem_;
  const CostMeter& meter_;
  Lockstep lockstep_;
};

}  // namespace obby::solve
