#include "train/history.h"

#include <algorithm>

#include "table/chart.h"

namespace obby::train {

void History::add(const Iteration& iteration) {
  reward += iteration.reward;
  if (++iterations < each) return;
  points.push_back({iteration.decisions, float(iteration.solved), iteration.hardest,
                    float(reward / iterations)});
  iterations = 0;
  reward = 0;
  if (points.size() < kMostPoints) return;
  for (size_t i = 0; i < points.size() / 2; ++i) {
    HistoryPoint both = points[2 * i + 1];
    both.reward = (points[2 * i].reward + both.reward) / 2;
    points[i] = both;
  }
  points.resize(points.size() / 2);
  each *= 2;
}

std::string curveSvg(const History& history) {
  table::ChartCurve solved{"episodes solved", {}, {}, {}};
  table::ChartCurve hardest{"max difficulty", {}, {}, {}};
  table::ChartCurve reward{"reward", {}, {}, {}};
  double least = 0, most = 0;
  for (const HistoryPoint& p : history.points) {
    const double at = double(p.decisions);
    solved.points.emplace_back(at, p.solved);
    hardest.points.emplace_back(at, p.hardest);
    reward.points.emplace_back(at, p.reward);
    least = std::min(least, double(p.reward));
    most = std::max(most, double(p.reward));
  }
  const double last = history.points.empty() ? 1 : double(history.points.back().decisions);
  const table::ChartAxis x = table::roundAxis("decisions", 0, last, false);
  return table::chartSvg(
      {{x, table::roundAxis("solved; max difficulty", 0, 1, true, 100, " %"), {solved, hardest}},
       {x, table::roundAxis("reward per decision", least, most, true), {reward}, 200}});
}

}  // namespace obby::train
