// The base of methods that learn during the search. Players always begin at the start. The archive
// has the cells that they stood in, with the trajectories to them, and the search keeps statistics.
// Cells in the air are left out: a falling player cannot return to one and stay. Host only.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "baselines/device_work.h"
#include "baselines/episode.h"
#include "baselines/names.h"
#include "policy/observation.h"
#include "policy/surroundings.h"
#include "solve/search/machine.h"
#include "solve/search/methods/archive_search.h"

namespace obby::baselines {

constexpr uint64_t kPlayerStreams = 1ull << 32;  // random streams, one per player

// Number of players that set out for a known state, and number that arrived.
struct Returns {
  uint64_t tried = 0, reached = 0;

  void add(const Returns& other) {
    tried += other.tried;
    reached += other.reached;
  }
};

// Max bytes of kept trajectories before unused ones are dropped.
constexpr size_t kForgetFrom = 64 << 20;

class LearnedSearch : public ArchiveSearch {
 public:
  void tryWarmStarts(size_t first, size_t count) override;
  // Plays with all players, records the results, then learns from them.
  void round() final;
  size_t bytesKept() const { return bytesKept_; }  // size of the kept trajectories

 protected:
  // `players`: number of players that play at once.
  LearnedSearch(const Problem& problem, uint64_t seed, const Machine& machine, uint32_t players,
                size_t forgetFrom = kForgetFrom);

  // Plays for a while, records the ended episodes in a fixed order, and learns.
  virtual void playAndLearn() = 0;
  // Marks the kept trajectories that players follow.
  virtual void markFollowed(std::vector<uint8_t>&) const {}

  const policy::Scene& scene() const { return scene_; }
  const Problem& problem() const { return problem_; }
  uint64_t seed() const { return seed_; }
  // Returns the pool for tasks that may use the device. With a device the pool has a single thread.
  ThreadPool& pool() { return device_ && device_->works() ? alone_ : pool_; }
  ThreadPool& allThreads() const { return pool_; }
  DeviceWork* device() const { return device_.get(); }  // or null

  // Calls play(first, count) for groups of players. With a device, which needs many players, it is
  // called once for all groups; otherwise once for each group, on a thread of the pool.
  void forGroups(size_t groups, const std::function<void(size_t, size_t)>& play);
  // Fills `inputs` with rows of policy::kInputs that begin `stride` numbers apart.
  void see(std::span<const View> views, float* inputs, size_t stride = policy::kInputs);

  // The following are safe to call from several threads between changes of the archive.

  Episode begin() const;
  // Returns true if the episode is running and can still succeed.
  bool goesOn(const Episode& e) const {
    return e.world.outcome == sim::Outcome::running && !doomed(context(), e.world);
  }
  // Plays one tick of all `episodes` with `actions`. goesOn() must be true for each.
  void advance(std::span<Episode* const> episodes, const sim::Action* actions);
  // Returns the action without a jump that would break the query's limits.
  sim::Action allowed(sim::Action action, const sim::World& world) const;
  // Returns the key of the cell that the episode would be in with the player's feet at `place`.
  uint64_t keyAt(const Episode& e, Vec3 place) const;
  float cellWidth() const { return 1 / setup_.rules.binning.inverseWidth; }

  // The following change the archive.

  void count(uint64_t steps) { statistics_.steps += steps; }
  // Records an ended episode. Call it once for each.
  void take(Episode& e) { take(e, problem_.known.size()); }

  // Returns the trajectory to the archive's state in a cell, and how many of its passed cells lead
  // there.
  std::pair<size_t, size_t> keptTo(uint32_t cell) const;
  const std::vector<Passed>& passed(size_t kept) const { return passed_[kept]; }
  const ActionRuns& actions(size_t kept) const { return problem_.known[kept]; }

 private:
  void tick(std::span<Episode* const> episodes, const sim::Action* actions);
  void look(Episode& e);
  void approach(Episode& e) const;
  void stand(Episode& e);
  void take(Episode& e, size_t kept);
  void keep(Episode& e, size_t kept);
  void forget();

  ThreadPool& pool_;
  ThreadPool alone_{1};
  const policy::Surroundings surroundings_;
  const policy::SurroundingsView around_;
  const policy::Scene scene_;           // refers to the surroundings
  std::unique_ptr<DeviceWork> device_;  // null without a device
  // problem_.known holds the given trajectories, then those of useful episodes.
  std::vector<std::vector<Passed>> passed_;  // (problem_.known)
  std::vector<uint8_t> shown_;  // (problem_.known), true if never dropped: shown, or a goal
  size_t bytesKept_ = 0, forgetFrom_;
};

}  // namespace obby::baselines
