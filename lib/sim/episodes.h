// A set of levels, and the order in which worlds play them. A world's next level depends only on
// its number and its episode, never on which world finishes first, so that CPU and GPU agree.
#pragma once

#include "level/query_view.h"
#include "sim/rigid_body.h"
#include "sim/world.h"

namespace obby::sim {

struct LevelSet {
  const level::LevelView* levels = nullptr;   // (levelCount)
  const level::QueryView* queries = nullptr;  // (levelCount), or null for no rules
  const World* starts = nullptr;              // (levelCount), where trajectories begin
  const RigidBody* startBodies = nullptr;     // (levelCount, bodyStride)
  const uint32_t* queue = nullptr;            // (queueLength), indices of levels
  uint32_t levelCount = 0, queueLength = 0;
  uint32_t bodyStride = 0;  // bodies reserved for each world
  bool restarts = false;    // a world whose trajectory has ended takes its next level
};

template <class Table>
OBBY_DEVICE void forTables(LevelSet& s, Table&& table) {
  table(s.levels, s.levelCount);
  table(s.queries, s.levelCount);
  table(s.starts, s.levelCount);
  table(s.startBodies, size_t(s.levelCount) * s.bodyStride);
  table(s.queue, s.queueLength);
}

// The trajectory that a world plays now.
struct Episode {
  uint32_t level = 0;   // index into LevelSet::levels
  uint32_t number = 0;  // trajectories before this one
};

// Returns the level of a world's episode. Worlds take levels from the queue in turns.
OBBY_DEVICE uint32_t levelOf(const LevelSet& s, uint32_t world, uint32_t worlds, uint32_t episode) {
  return s.queue[(world + uint64_t(episode) * worlds) % s.queueLength];
}

OBBY_DEVICE const level::QueryView* queryOf(const LevelSet& s, uint32_t level) {
  return s.queries != nullptr ? s.queries + level : nullptr;
}

// Puts a world and its dynamic bodies at the start of its next level.
OBBY_DEVICE void startNext(const LevelSet& s, uint32_t index, uint32_t worlds, Episode& episode,
                           World& world, RigidBody* bodies) {
  ++episode.number;
  episode.level = levelOf(s, index, worlds, episode.number);
  world = s.starts[episode.level];
  for (uint32_t b = 0; b < s.bodyStride; ++b) {
    bodies[b] = s.startBodies[episode.level * s.bodyStride + b];
  }
}

}  // namespace obby::sim
