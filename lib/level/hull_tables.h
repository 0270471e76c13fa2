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

// `vertices` must not be empty. Returns empty normals if they span no volume, or one that is
// thinner than 0.01 studs and 5000 times as wide.
HullTables hullTables(const std::vector<Vec3>& vertices);

// Returns the eight corners of the box around points, of which there must be at least one.
std::vector<Vec3> boxAround(const std::vector<Vec3>& points);

// Returns a view of the tables for shapes. Valid while the tables live.
geom::Hull viewOf(const HullTables& tables);

// The hulls of a level, each stored once: a place has many copies of one mesh.
class HullStore {
 public:
  // Returns null if the vertices span no volume. Valid while this store, or the one it was moved
  // to, lives.
  const geom::Hull* hullOf(const std::vector<Vec3>& vertices);

 private:
  std::unordered_map<std::string, const geom::Hull*> known_;  // keys are the bytes of the vertices
  std::deque<HullTables> tables_;  // addresses in a deque stay valid as it grows
  std::deque<geom::Hull> views_;
};

}  // namespace obby::level
