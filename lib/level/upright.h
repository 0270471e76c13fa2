// Makes blocks stand upright where they can: a block lying on its side is another block standing.
// Floor rays against upright blocks need two comparisons, and most parts of a level are such
// blocks. Rotations within 1e-6 of upright are snapped to it.
#pragma once

#include "level/level_view.h"
#include "level/motion_tables.h"

namespace obby::level {

// True, and pose and half extents changed to an equal block whose local Y is the world's, where one
// axis is vertical.
bool makeUpright(Collider& collider);

// True, and rows snapped, if local Y stays the world's Y all the time.
bool makeUpright(MotionTables& tables);

}  // namespace obby::level
