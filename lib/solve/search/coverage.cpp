#include "solve/search/coverage.h"

#include <algorithm>
#include <cmath>

namespace obby::solve {

namespace {

constexpr uint64_t kFirstPoint = 16384;  // steps
constexpr double kQuantile = 1.96;       // 97.5 % of a normal distribution
constexpr double kNoneSeen = 3.69;       // -ln(0.025): upper bound of n p if n trials all fail

double maxNew(const Coverage& t) {
  const double f = double(t.singletons);
  return f > 0 ? f + kQuantile * std::sqrt(2 * f) : kNoneSeen;
}

CoveragePoint pointOf(const Search& search) {
  const Statistics& s = search.statistics();
  return {s.steps, search.cellCount(), s.closest.distance};
}

}  // namespace

float newCellChance(const Coverage& t) {
  return t.rollouts == 0 ? 1 : float(std::min(maxNew(t) / double(t.rollouts), 1.0));
}

float newCellsIfTwice(const Coverage& t) {
  const uint64_t cells = t.curve.empty() ? 0 : t.curve.back().cells;
  return cells == 0 ? 1 : float(std::min(maxNew(t) / double(cells), 1.0));
}

bool saturated(const Coverage& t) {
  return t.rollouts >= kMinRollouts && newCellsIfTwice(t) <= kSaturated;
}

void CoverageLog::note(const Search& search) {
  const CoveragePoint here = pointOf(search);
  if (here.steps < next_) return;
  points_.push_back(here);
  next_ = std::max(kFirstPoint, next_);
  while (next_ <= here.steps) next_ *= 2;
}

Coverage CoverageLog::finish(const Search& search) {
  const CoveragePoint end = pointOf(search);
  if (points_.empty() || points_.back().steps < end.steps) points_.push_back(end);
  const Statistics& s = search.statistics();
  return {s.rollouts, s.idleRollouts, search.singletons(), std::move(points_)};
}

void fillEvidence(schema::SearchEvidence::Builder record, const Coverage& t) {
  record.setSaturation(saturated(t) ? schema::Saturation::SATURATED : schema::Saturation::GROWING);
  record.setRollouts(t.rollouts);
  record.setIdleRollouts(t.idleRollouts);
  record.setSingletons(t.singletons);
  record.setNewCellChance(newCellChance(t));
  auto curve = record.initCoverage(uint32_t(t.curve.size()));
  for (uint32_t i = 0; i < curve.size(); ++i) {
    curve[i].setSteps(t.curve[i].steps);
    curve[i].setCells(t.curve[i].cells);
    curve[i].setClosest(t.curve[i].closest);
  }
}

}  // namespace obby::solve
