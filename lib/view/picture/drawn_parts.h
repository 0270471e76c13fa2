// The parts of a level in a vector drawing.
#pragma once

#include <string>
#include <vector>

#include "view/picture/paper.h"
#include "view/picture/world.h"

namespace obby::view {

// Returns the path data of a polyline or, if `closed`, of a polygon.
std::string pathData(const std::vector<Vec2>& points, bool closed);

// Draws the farthest parts first. Flat faces are shaded by the sun. Parts outside of the drawing
// are left out.
std::string drawnParts(const World& world, const Paper& paper, float width, float height);

}  // namespace obby::view
