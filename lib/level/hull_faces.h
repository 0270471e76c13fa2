// Faces and edges of the convex hull of a set of corners. This is the costly half of hull_tables.h.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec.h"

namespace obby::level {

struct HullTables {
  std::vector<Vec3> vertices;  // without repetitions
  std::vector<Vec3> normals;   // unit, outward, coplanar triangles merged
  std::vector<float> offsets;
  std::vector<Vec3> edges;  // unit, each direction once; empty beyond kMaxHullEdges, because the
                            // faces alone describe a nearly round hull well enough
};

constexpr size_t kMaxHullVertices = 255;
constexpr size_t kMaxHullEdges = 32;

// Fills in normals, offsets and edges of a hull with at least one vertex and no repeated ones.
// `size` is the distance from its first vertex to the farthest, studs. A vertex up to `tolerance`
// studs below a face counts as on it. Leaves all tables empty if there are fewer than four faces.
void findFaces(HullTables& hull, float size, float tolerance);

}  // namespace obby::level
