// Plays variations of lines side by side in SIMD lanes. A new one may join whenever one ends, so
// that the lanes stay full.
#pragma once

#include <memory>
#include <vector>

#include "solve/improve/follower.h"
#include "solve/improve/lockstep.h"

namespace obby::solve {

using GuidedLines = std::vector<std::shared_ptr<const GuidedLine>>;

// A variation of a line: keep its first `start` ticks, then follow the guide from point `start` on.
struct Variation {
  Guide guide;
  uint32_t start = 0;  // tick of the line, and point of the guide
  FollowSettings settings;
  bool mayCostMore = false;  // by the line's risk, which it may make smaller
};

class VariationPool {
 public:
  // Both must outlive the pool.
  VariationPool(const Problem& problem, const CostMeter& meter);
  ~VariationPool();

  bool isFull() const;
  void add(std::shared_ptr<const GuidedLine> base, Variation variation);

  // Advances all by a tick. Returns the actions of those that reached the goal at a lower cost than
  // `best`, the cheapest first. Those that have become dearer end.
  std::vector<std::vector<sim::Action>> tick(const Line& best);

  uint64_t steps() const { return lockstep_.steps(); }  // simulated ticks

 private:
  struct Member;

  bool goesOn(const Member& member, const Line& best) const;

  const Problem& problem_;
  const CostMeter& meter_;
  Lockstep lockstep_;
  std::vector<std::unique_ptr<Member>> members_;
};

}  // namespace obby::solve
