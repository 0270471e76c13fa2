// What searches have in common that keep their states in an archive on the host, and each state's
// way as a chain of its nodes: what they tell of themselves, and how ends are tallied. Host only.
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
  Playthrough playthrough(const Node& end) const override {
    return regenerate(context(), seed_, problem_, archive_.nodes(), end);
  }

 protected:
  // The archive begins with the start.
  ArchiveSearch(const Problem& problem, uint64_t seed, const GoExploreSettings& settings);

  // To be called in a fixed order. countEnd(): what `way` ended as, in `world` among the bodies
  // `loose` (level.looseCount); countApproach(): how near to the goal it was. True:
  // playthrough(way) may be asked for.
  bool countEnd(const sim::World& world, const sim::LooseBody* loose, const Node& way);
  bool countApproach(const Approach& approach, const Node& way);
  // Those of countEnd() that arrived, since the last time, are the goals.
  void takeGoals();

  Problem problem_;
  const uint64_t seed_;
  const ExploreSetup setup_;
  Archive archive_;
  Statistics statistics_;
  Status deviceStatus_;

 private:
  Attempts attempts_;
  std::vector<std::pair<uint64_t, Node>> reached_;  // rank and way
  std::vector<Node> goals_;
};

}  // namespace obby::solve
