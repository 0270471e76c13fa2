// Makes blocks upright if possible: a block that lies on its side equals another block that stands.
// Floor rays against upright blocks need two comparisons, and most parts of a level are upright
// blocks. Rotations within 1e-6 of upright are snapped to it.
#pragma once

#include <vector>

#include "level/level_view.h"

namespace obby::level {

// If one axis is vertical, changes pose and half extents to those of an equal block whose local Y
// is the world's. Returns true if it did.
bool makeUpright(Collider& collider);

// Returns true if local Y is the world's Y in all rows.
bool isUpright(const std::vector<Pose>& keys);

// Makes rows that are upright except for rounding exactly upright.
void snapUpright(std::vector<Pose>& keys);

// Snaps the rows and returns true if all turns leave local Y unchanged.
bool makeUpright(std::vector<Mat3>& turns);

}  // namespace obby::level
