// Progress of training for a curve, in at most a thousand points.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "train/trainer.h"

namespace obby::train {

struct HistoryPoint {
  uint64_t decisions = 0;
  float solved = 0, hardest = 0;  // as in Iteration, at its end
  float reward = 0;               // per decision, mean since the last point
};

struct History {
  static constexpr size_t kMostPoints = 1000;

  // Adds an iteration. Merges pairs of points once there are too many.
  void add(const Iteration& iteration);

  std::vector<HistoryPoint> points;
  uint32_t each = 1;  // iterations per point
  // Sums since the last point.
  uint32_t iterations = 0;
  double reward = 0;  // sum
};

// Returns an SVG of solved share, difficulty and reward over decisions.
std::string curveSvg(const History& history);

}  // namespace obby::train
