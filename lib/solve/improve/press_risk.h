// Counts the jumps of a line that fail if the key is pressed a little early or late.
#pragma once

#include "solve/improve/follower.h"
#include "solve/improve/lockstep.h"

namespace obby::solve {

class PressRisk {
 public:
  // The problem must outlive this object.
  explicit PressRisk(const Problem& problem) : problem_(problem), lockstep_(problem) {}

  // Presses each jump of the line early and late, 33 and 67 ms at 60 ticks/s, and steers on to the
  // landing. Returns the number of presses that miss it, at most four for each jump.
  uint32_t missed(const Line& line);

  uint64_t steps() const { return lockstep_.steps(); }  // simulated ticks

 private:
  struct Press;

  void addPresses(const Line& line, uint32_t jump, std::vector<Press>& presses) const;

  const Problem& problem_;
  Lockstep lockstep_;
};

}  // namespace obby::solve
