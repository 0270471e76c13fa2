#include "solve/search/thoroughness.h"

#include <algorithm>
#include <cmath>

namespace obby::solve {

namespace {

constexpr uint64_t kFirstPoint = 16384;  // steps
constexpr double kQuantile = 1.96;       // 97.5 % of a normal distribution
constexpr double kNoneSeen = 3.69;       // -ln(0.025): upper bound of n p if n trials all fail

double mostNew(const Thoroughness& t) {
  const double f = double(t.singletons);
  return f > 0 ? f + kQuantile * std::sqrt(2 * f) : kNoneSeen;
}

CoveragePoint pointOf(const Search& search) {
  const Statistics& s = search.statistics();
  return {s.steps, search.cellCount(), s.closest.distance};
}

}  // namespace

float newCellChance(const Thoroughness& t) {
  return t.rollouts == 0 ? 1 : float(std::min(mostNew(t) / double(t.rollouts), 1.0));
}

float newCellsIfTwice(const Thoroughness& t) {
  const uint64_t cells = t.coverage.empty() ? 0 : t.coverage.back().cells;
  return cells == 0 ? 1 : float(std::min(mostNew(t) / double(cells), 1.0));
}

bool saturated(const Thoroughness& t) {
  return t.rollouts >= kLeastRollouts && newCellsIfTwice(t) <= kSaturated;
}

void CoverageLog::note(const Search& search) {
  const CoveragePoint here = pointOf(search);
  if (here.steps < next_) return;
  points_.push_back(here);
  next_ = std::max(kFirstPoint, next_);
  while (next_ <= here.steps) next_ *= 2;
}

Thoroughness CoverageLog::finish(const Search& search) {
  const CoveragePoint end = pointOf(search);
  if (points_.empty() || points_.back().steps < end.steps) points_.push_back(end);
  const Statistics& s = search.statistics();
  return {s.rollouts, s.idleRollouts, search.singletons(), std::move(points_)};
}

void fillEvidence(schema::SearchEvidence::Builder record, const Thoroughness& t) {
  record.setSaturation(saturated(t) ? schema::Saturation::SATURATED : schema::Saturation::GROWING);
  record.setRollouts(t.rollouts);
  record.setIdleRollouts(t.idleRollouts);
  record.setSingletons(t.singletons);
  record.setNewCellChance(newCellChance(t));
  auto coverage = record.initCoverage(uint32_t(t.coverage.size()));
  for (uint32_t i = 0; i < coverage.size(); ++i) {
    coverage[i].setSteps(t.coverage[i].steps);
    coverage[i].setCells(t.coverage[i].cells);
    coverage[i].setClosest(t.coverage[i].closest);
  }
}

}  // namespace obby::solve
