// Base of the searches that keep their states in an archive on the host, each with its trajectory
// as a chain of nodes. It reports on the search and tallies how attempts ended. Host only.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "solve/search/archive/archive.h"
#include "solve/search/regenerate.h"
#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/search.h"

namespace obby::solve {

class ArchiveSearch : public Search {
 public:
  const Statistics& statistics() const override { return statistics_; }
  const Archive& archive() const { return archive_; }
  const Attempts& attempts() const override { return attempts_; }
  const ExploreContext& context() const { return setup_.rules.context; }
  uint32_t cellCount() const override { return archive_.cellCount(); }
  Node newest() const override { return archive_.nodes()[archive_.node(cellCount() - 1)]; }
  uint64_t singletons() const override { return archive_.singletons(); }
  std::vector<Vec3> places(uint32_t first) const override;
  const Status& deviceStatus() const override { return deviceStatus_; }
  const std::vector<Node>& goals() const override { return goals_; }
  Trajectory trajectoryTo(const Node& end) const override {
    return regenerate(context(), seed_, problem_, archive_.nodes(), end);
  }

 protected:
  // Adds the start to the archive.
  ArchiveSearch(const Problem& problem, uint64_t seed, const GoExploreSettings& settings);

  // Both must be called in a fixed order. countEnd() notes how the attempt that leads to `node`
  // ended: in `world` with `bodies`, (level.bodyCount). countApproach() notes how near to the goal
  // the attempt came. They return true if trajectoryTo(node) may be asked for later.
  bool countEnd(const sim::World& world, const sim::RigidBody* bodies, const Node& node);
  bool countApproach(const Approach& approach, const Node& node);
  // Sets the goals to the arrivals noted by countEnd() since the last call, best first.
  void takeGoals();

  Problem problem_;
  const uint64_t seed_;
  const ExploreSetup setup_;
  Archive archive_;
  Statistics statistics_;
  Status deviceStatus_;

 private:
  Attempts attempts_;
  std::vector<std::pair<uint64_t, Node>> reached_;  // arrival rank and end of the trajectory
  std::vector<Node> goals_;
};

}  // namespace obby::solve
