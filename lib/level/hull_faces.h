// Which faces and edges a set of corners has: the costly half of hull_tables.h.
#pragma once

#include "level/hull_tables.h"

namespace obby::level {

// Fills in normals, offsets and edges of a hull whose vertices, at least one, are all apart.
// `size`: from its first vertex to the farthest, studs; `tolerance`: how far below a face a vertex
// may be that lies on it, studs. Nothing where there are fewer than four faces.
void findFaces(HullTables& hull, float size, float tolerance);

}  // namespace obby::level
