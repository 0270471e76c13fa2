// Kinodynamic RRT: draws a place, starts from the state nearest to it, and holds random keys for a
// random short time. As in SST, a shorter trajectory to a cell replaces a longer one. The nearest
// state is sought only among states equally far along the query, and that progress is drawn, too.
#pragma once

#include "solve/search/archive/nearest_cells.h"
#include "solve/search/rollouts/explore_setup.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

GoExploreSettings rrtSettings();

class RrtSelector : public Selector {
 public:
  RrtSelector(const Problem& problem, const ExploreContext& context);

  void choose(const Archive& archive, ThreadPool& pool, Random& random,
              std::span<Choice> choices) override;

 private:
  struct Target {
    uint32_t layer;  // waypoints and visits reached
    Vec3 position;
  };
  void addCells(const Archive& archive);
  Target draw(Random& random) const;
  const geom::Region& regionAfter(uint32_t layer, Random& random) const;
  Vec3 nearSurface(Random& random) const;

  level::LevelView level_;
  level::QueryView query_;
  SurfaceView surfaces_;
  sim::World start_;
  Box space_;           // where players can be
  float jumpHeight_;    // studs
  uint32_t known_ = 0;  // cells of the archive in nearest_
  NearestCells nearest_;
  std::vector<Target> targets_;  // targets of this round
};

std::unique_ptr<Selector> makeRrtSelector(const Problem& problem, const ExploreContext& context);

}  // namespace obby::solve
