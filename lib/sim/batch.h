// Many worlds of one level, stepped together by a thread pool. What a world becomes depends on its
// own state and actions only: the number of threads and the order of worlds never show.
#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include "base/thread_pool.h"
#include "level/level.h"
#include "sim/loose.h"
#include "sim/world.h"

namespace obby::sim {

class Batch {
 public:
  // All worlds at `start`. `level` must outlive the batch.
  Batch(const level::LevelView& level, const level::StartPose& start, size_t worlds);

  size_t size() const { return worlds_.size(); }
  const World& world(size_t i) const { return worlds_[i]; }

  std::span<const LooseBody> loose(size_t i) const {
    return std::span(loose_).subspan(i * level_.looseCount, level_.looseCount);
  }

  // Snapshots are plain copies of a world and its loose bodies.
  void restore(size_t i, const World& snapshot, std::span<const LooseBody> loose = {}) {
    worlds_[i] = snapshot;
    std::copy(loose.begin(), loose.end(), loose_.begin() + i * level_.looseCount);
  }

  // Gives the action of world `i` at its tick; called from any thread.
  using Controller = std::function<Action(size_t i, const World& world)>;

  // Advances every running world by `ticks`, asking the controller before each. `query` may be
  // null.
  void step(ThreadPool& pool, const level::QueryView* query, uint32_t ticks,
            const Controller& controller);

  // Digest of all states in order.
  uint64_t hash() const;

 private:
  const level::LevelView& level_;
  std::vector<World> worlds_;
  std::vector<LooseBody> loose_;  // (worlds, level.looseCount)
};

}  // namespace obby::sim
