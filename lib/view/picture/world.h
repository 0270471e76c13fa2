// The solids of a level as a picture shows them.
#pragma once

#include "view/picture/shade.h"
#include "view/report.h"

namespace obby::view {

struct World {
  std::vector<Solid> solids;      // one per collider of the level
  std::vector<Surface> surfaces;  // one for each solid
  std::vector<bool> away;         // true for each solid that is without collision at that tick
};

// Moving parts have their poses at that tick of the level clock, and touch-triggered ones are at
// rest. Parts that are away are almost transparent. Plain parts have their own colour, other parts
// the colour of their role.
World worldOf(const LevelEntry& entry, uint32_t tick);

}  // namespace obby::view
