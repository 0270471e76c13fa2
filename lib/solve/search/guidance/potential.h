// Computes how promising states are under a query. Host only.
#pragma once

#include <vector>

#include "solve/model/problem.h"
#include "solve/search/guidance/potential_view.h"

namespace obby::solve {

class Potential {
 public:
  explicit Potential(const Problem& problem);
  float operator()(const sim::World& world) const { return potentialOf(view(), query_, world); }
  PotentialView view() const { return {spans_.data(), uint32_t(spans_.size())}; }

 private:
  level::QueryView query_;
  std::vector<float> spans_;  // (targets + 1), 1.5 d0 of each segment
};

}  // namespace obby::solve
