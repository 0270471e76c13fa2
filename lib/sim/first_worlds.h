// The worlds with which every batch begins. Private to lib/sim.
#pragma once

#include "sim/batch.h"

namespace obby::sim {

struct FirstWorlds {
  std::vector<World> worlds;
  std::vector<Episode> episodes;
  std::vector<RigidBody> bodies;  // (worlds, Course::bodyStride)
};

// Checks the course, and sets the dynamic bodies of its starts. An empty queue becomes all levels
// in order.
Result<FirstWorlds> firstWorlds(Course& course, uint32_t count);

}  // namespace obby::sim
