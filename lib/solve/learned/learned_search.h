// What methods have in common that learn while they search: players who always begin at the start,
// an archive of the cells that they stood in with the ways there as they were played, and what a
// search tells of itself. Who is in the air is on the way to elsewhere, mostly down: nobody could
// be told to return there. Host only.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "policy/observation.h"
#include "policy/surroundings.h"
#include "solve/learned/device_work.h"
#include "solve/learned/episode.h"
#include "solve/search/machine.h"
#include "solve/search/methods/archive_search.h"

namespace obby::solve::learned {

constexpr uint64_t kPlayerStreams = 1ull << 32;  // of random numbers, one for each player

// How many players set out to return to where others had been, and how many of these came there.
struct Returns {
  uint64_t tried = 0, reached = 0;

  void add(const Returns& other) {
    tried += other.tried;
    reached += other.reached;
  }
};

// Bytes of kept playthroughs from which on those are forgotten that nothing leads along any more.
constexpr size_t kForgetFrom = 64 << 20;

class LearnedSearch : public ArchiveSearch {
 public:
  void tryKnown(size_t first, size_t count) override;
  // Players play, what came of it is taken, then is learned from.
  void round() final;
  size_t bytesKept() const { return bytesKept_; }  // of playthroughs

 protected:
  // `players`: those who play at once.
  LearnedSearch(const Problem& problem, uint64_t seed, const Machine& machine, uint32_t players,
                size_t forgetFrom = kForgetFrom);

  // Plays for a while, takes the episodes that ended, in a fixed order, and learns.
  virtual void playAndLearn() = 0;
  // Marks the kept ways that players are on.
  virtual void markFollowed(std::vector<uint8_t>&) const {}

  const policy::Scene& scene() const { return scene_; }
  const Problem& problem() const { return problem_; }
  uint64_t seed() const { return seed_; }
  // Where tasks run that may ask the device: by themselves as long as there is one.
  ThreadPool& pool() { return device_ && device_->works() ? alone_ : pool_; }
  ThreadPool& allThreads() const { return pool_; }
  DeviceWork* device() const { return device_.get(); }  // or null

  // Calls play(first, count) for groups of players: for all at once where there is a device, which
  // wants many, otherwise for each on a thread of the pool.
  void forGroups(size_t groups, const std::function<void(size_t, size_t)>& play);
  // Fills `inputs`, rows of policy::kInputs that begin `stride` numbers apart.
  void see(std::span<const View> views, float* inputs, size_t stride = policy::kInputs);

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
  void tick(std::span<Episode* const> episodes, const sim::Action* actions);
  void look(Episode& e);
  void approach(Episode& e) const;
  void stand(Episode& e);
  void take(Episode& e, size_t way);
  void keep(Episode& e, size_t way);
  void forget();

  // The problem's known ways are followed by those of the episodes that are of use.
  ThreadPool& pool_;
  ThreadPool alone_{1};
  const policy::Surroundings surroundings_;
  const policy::SurroundingsView around_;
  const policy::Scene scene_;                // of these
  std::unique_ptr<DeviceWork> device_;       // null without a device
  std::vector<std::vector<Passed>> passed_;  // (problem_.known)
  std::vector<uint8_t> shown_;  // (problem_.known), kept for ever: an end to show, or a goal
  size_t bytesKept_ = 0, forgetFrom_;
};

}  // namespace obby::solve::learned
