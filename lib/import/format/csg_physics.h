// Reads the collision shape that Studio saves with unions and mesh parts. It consists of convex
// hulls, since the geometry itself is not in the file.
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
  Unsupported,  // damaged or of an unknown version: callers use the box and say so
};

struct Collision {
  CollisionKind kind = CollisionKind::Absent;
  std::string detail;  // for messages: "CSGPHS 7, 3 hulls", "CSGPHS 9 is not supported"
  std::vector<std::vector<Vec3>> hulls;  // corners of each, at least four
};

// Decodes `blob`, the bytes of PhysicalConfigData or PhysicsData. Corners are in the space of the
// part's InitialSize. Fails only if the blob is damaged.
Result<Collision> decodeCollision(std::string_view blob);

// The collision bytes of a mesh part or union: PhysicalConfigData, else PhysicsData.
struct CollisionBlob {
  const char* property = "";
  std::string_view bytes;  // empty if there are none
  bool shared = false;     // other parts may share these bytes at this address
};
CollisionBlob collisionBlobOf(const Instance& part);

// Works as decodeCollision, but damage makes the shape Unsupported, with the reason in `detail`.
Collision collisionFrom(const CollisionBlob& blob);

// Returns Size / InitialSize, which takes corners to the part's own space.
Vec3 hullScaleOf(const Instance& part);

}  // namespace obby::importer
