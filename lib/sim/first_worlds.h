// How every batch begins: what its worlds play first. Private to lib/sim.
#pragma once

#include "sim/batch.h"

namespace obby::sim {

struct FirstWorlds {
  std::vector<World> worlds;
  std::vector<Episode> episodes;
};

// Checks the course and fills an empty queue.
Result<FirstWorlds> firstWorlds(Course& course, uint32_t count);

}  // namespace obby::sim
