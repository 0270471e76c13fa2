// Face and edge tables of a convex hull from its vertices.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "geom/shape.h"
#include "level/hull_faces.h"
#include "math/vec.h"

namespace obby::level {

// Empty normals if the vertices do not span a volume, or one thinner than 0.01 studs that is 5000
// times as wide. At least one vertex.
HullTables hullTables(const std::vector<Vec3>& vertices);

// The eight corners of the box around points, at least one.
std::vector<Vec3> boxAround(const std::vector<Vec3>& points);

// The tables as shapes read them; valid while they live.
geom::Hull viewOf(const HullTables& tables);

// The hulls of a level, each of them once: a place has many copies of one mesh.
class HullStore {
 public:
  // Null if the vertices do not span a volume. Valid while this, or what it was moved to, lives.
  const geom::Hull* hullOf(const std::vector<Vec3>& vertices);

 private:
  std::unordered_map<std::string, const geom::Hull*> known_;  // by the bytes of the vertices
  std::deque<HullTables> tables_;                             // a deque keeps addresses
  std::deque<geom::Hull> views_;
};

}  // namespace obby::level
