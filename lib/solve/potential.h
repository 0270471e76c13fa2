// How promising a state is for the search, apart from how often its like was seen.
#pragma once

#include <vector>

#include "sim/world.h"
#include "solve/problem.h"

namespace obby::solve {

// How promising a state is, whatever its count: (1 + 4 max(0, 1 - d / (1.5 d0))) (1 + 3 targets),
// targets the waypoints and visits behind, d the distance to the next region, d0 what it was when
// that became the next; with a choice of regions, the farthest that it can have been.
class Potential {
 public:
  explicit Potential(const Problem& problem);
  float operator()(const sim::World& world) const;

 private:
  level::QueryView query_;
  std::vector<float> spans_;  // (targets + 1), 1.5 d0 of each leg
};

}  // namespace obby::solve
