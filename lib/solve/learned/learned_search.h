// What methods have in common that learn while they search: players who always begin at the start,
// an archive of the cells that they came to with the ways there as they were played, and what a
// search tells of itself. Host only.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "policy/observation.h"
#include "policy/surroundings.h"
#include "solve/archive.h"
#include "solve/explore_setup.h"
#include "solve/learned/episode.h"
#include "solve/machine.h"
#include "solve/search.h"

namespace obby::solve::learned {

// How many players set out to return to where others had been, and how many of these came there.
struct Returns {
  uint64_t tried = 0, reached = 0;

  void add(const Returns& other) {
    tried += other.tried;
    reached += other.reached;
  }
};

class LearnedSearch : public Search {
 public:
  void tryKnown(size_t first, size_t count) override;
  // Players play, what came of it is taken, then is learned from.
  void round() final;

  const Statistics& statistics() const override { return statistics_; }
  const Attempts& attempts() const override { return attempts_; }
  uint32_t cellCount() const override { return archive_.cellCount(); }
  Node newest() const override { return archive_.nodes()[archive_.node(cellCount() - 1)]; }
  uint64_t singletons() const override { return archive_.singletons(); }
  std::vector<Vec3> places(uint32_t first) const override;
  const Status& deviceStatus() const override { return deviceStatus_; }
  const std::vector<Node>& goals() const override { return goals_; }
  Playthrough playthrough(const Node& end) const override {
    return regenerate(context(), seed_, problem_, archive_.nodes(), end);
  }
  const Archive& archive() const { return archive_; }

 protected:
  // Of `machine`, the pool is used.
  LearnedSearch(const Problem& problem, uint64_t seed, const Machine& machine);

  // Plays for a while on the pool's threads, takes the episodes that ended, in a fixed order, and
  // learns.
  virtual void playAndLearn() = 0;

  const ExploreContext& context() const { return setup_.rules.context; }
  const policy::Scene& scene() const { return scene_; }
  const Problem& problem() const { return problem_; }
  uint64_t seed() const { return seed_; }
  ThreadPool& pool() const { return pool_; }

  // The rest is safe to call from several threads between changes of the archive.

  Episode begin() const;
  // Not over, and not hopeless.
  bool goesOn(const Episode& e) const {
    return e.world.outcome == sim::Outcome::running && !doomed(context(), e.world);
  }
  // One tick of all `episodes`, each of which goes on, under `actions`.
  void advance(std::span<Episode* const> episodes, const sim::Action* actions);
  // The action, without a jump that would break the query's limits.
  sim::Action allowed(sim::Action action, const sim::World& world) const;
  // The cell's key if the player's feet were at `place`.
  uint64_t keyAt(const Episode& e, Vec3 place) const;
  float cellWidth() const { return 1 / setup_.rules.binning.inverseWidth; }

  // These change the archive.

  void count(uint64_t steps) { statistics_.steps += steps; }
  // To be called once for each episode that ended.
  void take(Episode& e) { take(e, problem_.known.size()); }

  // The way to the archive's state in a cell, and how many of the cells passed on it lead there.
  std::pair<size_t, size_t> wayTo(uint32_t cell) const;
  const std::vector<Passed>& passed(size_t way) const { return passed_[way]; }
  const KnownWay& actions(size_t way) const { return problem_.known[way]; }

 private:
  void look(Episode& e);
  void enter(Episode& e);
  void take(Episode& e, size_t way);
  void takeEnd(const Episode& e, const Node& end, bool& needed);
  void sortGoals();

  Problem problem_;  // its known ways are followed by those of the episodes that are of use
  const uint64_t seed_;
  ThreadPool& pool_;
  const ExploreSetup setup_;
  const policy::Surroundings surroundings_;
  const policy::SurroundingsView around_;
  const policy::Scene scene_;                // of these
  std::vector<std::vector<Passed>> passed_;  // (problem_.known)
  Archive archive_;
  Attempts attempts_;
  Statistics statistics_;
  Status deviceStatus_;
  std::vector<std::pair<uint64_t, Node>> reached_;  // rank and way, of this round
  std::vector<Node> goals_;
};

}  // namespace obby::solve::learned
