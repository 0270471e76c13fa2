// The order in which solids are painted, so that nearer ones cover farther ones.
#pragma once

#include <cstddef>
#include <vector>

#include "view/picture/canvas.h"
#include "view/picture/paper.h"

namespace obby::view {

// `outlines`: each solid's outline on paper, convex; a solid with an empty outline is left out.
// Returns indices, the farthest first. Where solids intersect or cover each other in a ring, the
// one whose nearest point is farther comes first.
std::vector<size_t> depthOrder(const std::vector<Solid>& solids,
                               const std::vector<std::vector<Vec2>>& outlines, const Paper& paper);

}  // namespace obby::view
