// Which faces and edges a set of corners has: the costly half of hull_tables.h.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec.h"

namespace obby::level {

struct HullTables {
  std::vector<Vec3> vertices;  // without repetitions
  std::vector<Vec3> normals;   // unit, outward, coplanar triangles merged
  std::vector<float> offsets;
  std::vector<Vec3> edges;  // unit, each direction once; empty beyond kMaxHullEdges, where the
                            // faces alone describe a nearly round hull well enough
};

constexpr size_t kMaxHullVertices = 255;
constexpr size_t kMaxHullEdges = 32;

// Fills in normals, offsets and edges of a hull whose vertices, at least one, are all apart.
// `size`: from its first vertex to the farthest, studs; `tolerance`: how far below a face a vertex
// may be that lies on it, studs. Nothing where there are fewer than four faces.
void findFaces(HullTables& hull, float size, float tolerance);

}  // namespace obby::level
