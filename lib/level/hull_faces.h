// Faces and edges of the convex hull of a set of corners. This is the costly half of hull_tables.h.
#pragma once

#include "level/hull_tables.h"

namespace obby::level {

// Fills in normals, offsets and edges of a hull with at least one vertex and no repeated ones.
// `size` is the distance from its first vertex to the farthest, studs. `tolerance` is how far below
// a face a vertex on it may be, studs. Leaves all empty if there are fewer than four faces.
void findFaces(HullTables& hull, float size, float tolerance);

}  // namespace obby::level
