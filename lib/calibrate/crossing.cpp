#include "calibrate/crossing.h"

#include <algorithm>
#include <limits>

#include "calibrate/evidence.h"

namespace obby::calibrate {

namespace {

constexpr size_t kValues = 16;  // number of values tried

// Refines all coordinates but one. Returns `point` if that fails.
std::vector<double> refinedWithout(const Objective& objective, std::vector<double> point,
                                   size_t coordinate, int rounds, const Work& work) {
  const auto at = std::ptrdiff_t(coordinate);
  if (coordinate == objective.parameters().size()) {
    auto found = refined(objective, point, rounds, work);
    return found ? *std::move(found) : point;
  }
  std::vector<Parameter> others = objective.parameters();
  others.erase(others.begin() + at);
  const Objective less = objective.from(point, std::move(others));
  std::vector<double> there = point;
  there.erase(there.begin() + at);
  auto found = refined(less, std::move(there), rounds, work);
  if (!found) return point;
  found->insert(found->begin() + at, point[coordinate]);
  return *std::move(found);
}

// Returns the index of the first value of each run of equal losses. That value represents the run.
std::vector<size_t> runsOf(const std::vector<double>& losses) {
  std::vector<size_t> out;
  for (size_t i = 0; i < losses.size(); ++i) {
    if (i == 0 || losses[i] != losses[i - 1]) out.push_back(i);
  }
  return out;
}

}  // namespace

std::vector<double> sharesAllOver() {
  std::vector<double> out;
  for (size_t i = 0; i < kValues; ++i) out.push_back((double(i) + 0.5) / kValues);
  return out;
}

std::vector<double> sharesAround(double share) {
  constexpr int kAround = 4;
  std::vector<double> out;
  for (int i = -kAround; i <= kAround; ++i) {
    const double there = share + i / (kValues * 2.0 * kAround);
    if (there >= 0 && there <= 1) out.push_back(there);
  }
  return out;
}

std::vector<double> delaysAround(const Objective& objective, double share) {
  constexpr int kAround = 2;
  const std::vector<double> ticks = objective.delayShares(1 / objective.controlRate());
  const double tick = ticks[1] - ticks[0];
  std::vector<double> out;
  for (int i = -kAround; i <= kAround; ++i) {
    const double there = share + i * tick;
    if (i != 0 && there >= 0 && there <= 1) out.push_back(there);
  }
  return out;
}

Crossing crossingOf(const Objective& objective, const std::vector<double>& point, size_t coordinate,
                    const std::vector<double>& shares, int rounds, const Work& work) {
  const size_t count = shares.size();
  const std::vector<double> untried(count, std::numeric_limits<double>::max());
  Crossing out{{coordinate, shares, untried}, point, objective.loss(point)};
  std::vector<double>& losses = out.profile.losses;
  std::vector<std::vector<double>> points(count, point);
  for (size_t i = 0; i < count; ++i) points[i][coordinate] = shares[i];
  const auto measure = [&](size_t i) {
    losses[i] = objective.loss(points[i]);
    work.account().count(1);
  };
  work.run(int(count), [&](int i) { measure(size_t(i)); });
  if (work.stopped()) return out;
  const std::vector<size_t> runs = runsOf(losses);
  work.run(int(runs.size()), [&](int k) {
    const size_t i = runs[size_t(k)];
    points[i] = refinedWithout(objective, std::move(points[i]), coordinate, rounds, work.inTask());
    measure(i);
  });
  for (size_t k = 0; k < runs.size(); ++k) {
    const size_t first = runs[k], end = k + 1 < runs.size() ? runs[k + 1] : count;
    for (size_t i = first; i < end; ++i) losses[i] = losses[first];
    if (alike(out.loss, losses[first])) continue;
    out.loss = losses[first];
    // Takes the middle of the values that have the same loss.
    out.best = points[first];
    out.best[coordinate] = shares[(first + end - 1) / 2];
  }
  return out;
}

}  // namespace obby::calibrate
