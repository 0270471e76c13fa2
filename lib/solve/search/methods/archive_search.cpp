#include "solve/search/methods/archive_search.h"

#include <algorithm>

#include "solve/search/rollouts/blame.h"

namespace obby::solve {

ArchiveSearch::ArchiveSearch(const Problem& problem, uint64_t seed,
                             const GoExploreSettings& settings)
    : problem_(problem),
      seed_(seed),
      setup_(problem_, seed, settings),
      archive_(kMaxCells, problem_.level.bodyCount) {
  const sim::World& start = problem_.start;
  const sim::RigidBody* const bodies = problem_.startBodies.data();
  archive_.offer(cellKey(setup_.rules.binning, start, bodies), start, {0, kNone, 0},
                 setup_.potential(start), bodies);
  statistics_.closest.distance = distanceLeft(problem_.query, start);
  statistics_.closest.position = start.position;
}

std::vector<Vec3> ArchiveSearch::places(uint32_t first) const {
  std::vector<Vec3> result;
  for (; first < cellCount(); ++first) result.push_back(archive_.world(first).position);
  return result;
}

bool ArchiveSearch::countEnd(const sim::World& world, const sim::RigidBody* bodies,
                             const Node& node) {
  statistics_.overruns |= uint8_t(world.flags & sim::kOverruns);
  if (world.outcome == sim::Outcome::goal) {
    reached_.push_back({arrivalRank(world), node});
    return true;
  }
  const bool falls = fallsOn(context(), world);
  return attempts_.add({{node.rollout, node.parent, falls ? kFallTicks : node.ticks},
                        world.position,
                        falls ? sim::Outcome::fell : world.outcome,
                        blamedPart(world, bodies, problem_.level)});
}

bool ArchiveSearch::countApproach(const Approach& approach, const Node& node) {
  if (!closer(approach, statistics_.closest)) return false;
  statistics_.closest = {approach, node};
  return true;
}

void ArchiveSearch::takeGoals() {
  std::stable_sort(reached_.begin(), reached_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  goals_.clear();
  for (const auto& [rank, node] : reached_) goals_.push_back(node);
  reached_.clear();
}

}  // namespace obby::solve
