// Computes the distances of a query that the beam's rank needs. Host only.
#pragma once

#include <vector>

#include "solve/model/problem.h"
#include "solve/search/guidance/beam_view.h"

namespace obby::solve {

class BeamRoute {
 public:
  explicit BeamRoute(const Problem& problem);
  BeamView view() const {
    return {segments_.data(), hops_.data(), uint32_t(segments_.size()), uint32_t(hops_.size()),
            ticksPerStud_};
  }

 private:
  float ticksPerStud_;
  std::vector<float> segments_, hops_;
};

}  // namespace obby::solve
