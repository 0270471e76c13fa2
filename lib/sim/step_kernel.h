// The kernel that steps worlds, with one world per thread and several ticks per launch.
// cuda/step.cu launches it on a GPU, and host_device.h runs it on the CPU for tests.
//
// A world is loaded and stored once per launch. Its 128 bytes are a cache line of their own, and
// all of them are used, so a transposed layout would save no traffic. 256 bytes per launch are
// little compared with the ticks in between.
#pragma once

#include "sim/actions.h"
#include "sim/episodes.h"
#include "sim/kernel.h"
#include "sim/rules.h"
#include "sim/tick.h"

namespace obby::sim {

struct StepArguments {
  LevelSet set;
  level::LevelView only;  // the level if there is only one; a GPU receives it as constants
  ActionView actions;
  World* worlds;      // (count)
  RigidBody* bodies;  // (count, set.bodyStride); updated in place
  Episode* episodes;  // (count)
  uint32_t count, ticks;
};

template <StepKind kKind>
OBBY_DEVICE void stepWorld(const StepArguments& a, uint32_t i) {
  World world = a.worlds[i];
  RigidBody* const bodies = a.bodies + size_t(i) * a.set.bodyStride;
  Episode episode = a.episodes[i];
  ActionCursor cursor;
  for (uint32_t t = 0; t < a.ticks; ++t) {
    if (world.outcome != Outcome::running) {
      if (!a.set.restarts) break;
      startNext(a.set, i, a.count, episode, world, bodies);
      cursor.startOver(a.actions);
    }
    const level::LevelView& level =
        kKind == StepKind::oneLevel ? a.only : a.set.levels[episode.level];
    const Before before = beforeOf(world);
    tick<kKind == StepKind::bodies>(
        world, bodies, level, cursor.next(a.actions, {i, a.count, episode.number, t}, world.tick));
    const level::QueryView* query = queryOf(a.set, episode.level);
    if (query != nullptr) applyRules(world, before, bodies, level, *query);
  }
  a.worlds[i] = world;
  a.episodes[i] = episode;
}

}  // namespace obby::sim
