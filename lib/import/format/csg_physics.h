// The collision shape that Studio saves with unions and mesh parts: convex hulls, since the
// geometry itself lives elsewhere.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "engine/document.h"

namespace obby::importer {

enum class CollisionKind {
  Absent,       // the file has no collision data
  Box,          // the part's bounding box is the exact shape
  Hulls,        // convex hulls
  Unsupported,  // a version that is not known, or damaged: use the box, and say so
};

struct Collision {
  CollisionKind kind = CollisionKind::Absent;
  std::string detail;  // for people: "CSGPHS 7, 3 hulls", "CSGPHS 9 is not supported"
  std::vector<std::vector<Vec3>> hulls;  // corners of each, at least four
};

// `blob` is PhysicalConfigData or PhysicsData. Corners are in the space of the part's InitialSize.
// Fails on damage only.
Result<Collision> decodeCollision(std::string_view blob);

// Where a mesh part or union keeps its collision: in PhysicalConfigData, else in PhysicsData.
struct CollisionBlob {
  const char* property = "";
  std::string_view bytes;  // empty: there is none
  bool shared = false;     // other parts may have these bytes, at this address
};
CollisionBlob collisionBlobOf(const Instance& part);

// As decodeCollision, but damage makes it Unsupported, with the reason in `detail`.
Collision collisionFrom(const CollisionBlob& blob);

// Size / InitialSize: takes corners to the part's own space.
Vec3 hullScaleOf(const Instance& part);

}  // namespace obby::importer
