// How learning went, for a curve: at most a thousand points, however long it takes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "train/trainer.h"

namespace obby::train {

struct HistoryPoint {
  uint64_t decisions = 0;
  float solved = 0, hardest = 0;  // as in Iteration, at its end
  float reward = 0;               // a decision, mean since the last point
};

struct History {
  static constexpr size_t kMostPoints = 1000;

  // Once there are too many points, two become one.
  void add(const Iteration& iteration);

  std::vector<HistoryPoint> points;
  uint32_t each = 1;  // iterations a point
  // Since the last point.
  uint32_t iterations = 0;
  double reward = 0;  // sum
};

// Share of playthroughs solved, difficulty and reward over decisions, as an SVG.
std::string curveSvg(const History& history);

}  // namespace obby::train
