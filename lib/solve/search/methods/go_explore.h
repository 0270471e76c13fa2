// Go-Explore in rounds. A selector picks cells, and all threads roll out from them against a
// snapshot of the archive. The finds are merged in the order of the rollouts. The result follows
// from (problem, seed, settings, selector); threads and time only decide when the search stops.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solve/search/machine.h"
#include "solve/search/methods/archive_search.h"
#include "solve/search/rollouts/companions.h"
#include "solve/search/rollouts/device_rollouts.h"
#include "solve/search/rollouts/rollout_group.h"
#include "solve/search/selectors/selection.h"
#include "solve/search/selectors/selector.h"

namespace obby::solve {

class GoExplore final : public ArchiveSearch {
 public:
  // Only tryWarmStarts() and round() use `machine`. A device that fails is not used again; the pool
  // goes on with the same results.
  GoExplore(const Problem& problem, uint64_t seed, const GoExploreSettings& settings,
            const Machine& machine, MakeSelector makeSelector = hedgedSelector);

  void tryWarmStarts(size_t first, size_t count) override;
  void round() override;

 private:
  struct Candidate {  // a state that is new, or better than the one in the archive
    uint64_t key;
    sim::World world;
    std::vector<sim::RigidBody> bodies;  // empty: equal to those of the first world
    float potential;
    uint32_t ticks;
  };
  struct Rollout {
    uint64_t id = 0;
    Choice start{};
    uint32_t parent = 0;  // node of the start
    uint32_t ticks = 0;
    uint32_t closestTicks = 0;
    Approach closest;
    sim::World end;
    std::vector<sim::RigidBody> endBodies;
    std::vector<Candidate> candidates;
  };

  uint32_t roundSize() const;
  void chooseCells();
  struct Look {  // the cell of a rollout after a tick
    uint64_t key;
    uint32_t member;  // index in the group
    bool isNew;       // see Trail
  };

  void follow(Rollout& rollout, const ActionRuns& runs);
  void exploreOnThreads();
  Status openDevice();
  Status exploreOnDevice();
  void explore(std::span<Rollout> rollouts);
  void listLooks(const RolloutGroup& group, std::span<const Trail> trails,
                 std::vector<Look>& looks) const;
  void look(const RolloutGroup& group, std::span<Rollout> rollouts, std::span<Trail> trails,
            std::span<const Look> looks, uint32_t tick);
  void visit(Rollout& rollout, uint64_t key, uint32_t cell, const sim::World& world,
             std::span<const sim::RigidBody> bodies, uint32_t ticks);
  void noteClosest(Rollout& rollout, const sim::World& world, uint32_t tick);
  void merge();
  Tried keep(const Rollout& rollout);
  bool offer(const Rollout& rollout, const Candidate& candidate, Companions::Walk* walk);

  const GoExploreSettings settings_;
  Machine machine_;
  std::optional<DeviceRollouts> device_;
  std::unique_ptr<Selector> selector_;
  Companions companions_;
  std::vector<Choice> choices_;    // choices of this round
  std::vector<Rollout> rollouts_;  // (choices)
  std::vector<Tried> tried_;       // (choices)
  uint64_t nextRollout_ = 0;
};

}  // namespace obby::solve
