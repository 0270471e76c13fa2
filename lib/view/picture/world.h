// The solids of a level as a picture shows them.
#pragma once

#include "view/picture/shade.h"
#include "view/report.h"

namespace obby::view {

struct World {
  std::vector<Solid> solids;      // one a collider of the level
  std::vector<Surface> surfaces;  // of each
  std::vector<bool> away;         // of each: without its collision now
};

// Moving parts are where they are at that tick of the level's clock, those that wait for a touch at
// rest; what is away then is hardly there. Plain parts have their own colour, others that of their
// role.
World worldOf(const LevelEntry& entry, uint32_t tick);

}  // namespace obby::view
