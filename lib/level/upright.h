// Makes blocks stand upright where they can: a block lying on its side is another block standing.
// Floor rays against upright blocks need two comparisons, and most parts of a level are such
// blocks. Rotations within 1e-6 of upright are snapped to it.
#pragma once

#include <vector>

#include "level/level_view.h"

namespace obby::level {

// True, and pose and half extents changed to an equal block whose local Y is the world's, where one
// axis is vertical.
bool makeUpright(Collider& collider);

// Is local Y the world's Y in all rows?
bool isUpright(const std::vector<Pose>& keys);

// Makes rows that are upright exactly so.
void snapUpright(std::vector<Pose>& keys);

// True, and rows snapped, if the turns leave local Y where it is.
bool makeUpright(std::vector<Mat3>& turns);

}  // namespace obby::level
