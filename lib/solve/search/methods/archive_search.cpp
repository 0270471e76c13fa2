#include "solve/search/methods/archive_search.h"

#include <algorithm>

#include "solve/search/rollouts/blame.h"

namespace obby::solve {

ArchiveSearch::ArchiveSearch(const Problem& problem, uint64_t seed,
                             const GoExploreSettings& settings)
    : problem_(problem),
      seed_(seed),
      setup_(problem_, seed, settings),
      archive_(kMaxCells, problem_.level.looseCount) {
  const sim::World& start = problem_.start;
  const sim::LooseBody* const loose = problem_.startLoose.data();
  archive_.offer(cellKey(setup_.rules.binning, start, loose), start, {0, kNone, 0},
                 setup_.potential(start), loose);
  statistics_.closest.distance = distanceLeft(problem_.query, start);
  statistics_.closest.position = start.position;
}

std::vector<Vec3> ArchiveSearch::places(uint32_t first) const {
  std::vector<Vec3> result;
  for (; first < cellCount(); ++first) result.push_back(archive_.world(first).position);
  return result;
}

bool ArchiveSearch::countEnd(const sim::World& world, const sim::LooseBody* loose,
                             const Node& way) {
  statistics_.overruns |= uint8_t(world.flags & sim::kOverruns);
  if (world.outcome == sim::Outcome::goal) {
    reached_.push_back({arrivalRank(world), way});
    return true;
  }
  const bool falls = fallsOn(context(), world);
  return attempts_.add({{way.rollout, way.parent, falls ? kFallTicks : way.ticks},
                        world.position,
                        falls ? sim::Outcome::fell : world.outcome,
                        blamedPart(world, loose, problem_.level)});
}

bool ArchiveSearch::countApproach(const Approach& approach, const Node& way) {
  if (!closer(approach, statistics_.closest)) return false;
  statistics_.closest = {approach, way};
  return true;
}

void ArchiveSearch::takeGoals() {
  std::stable_sort(reached_.begin(), reached_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  goals_.clear();
  for (const auto& [rank, way] : reached_) goals_.push_back(way);
  reached_.clear();
}

}  // namespace obby::solve
