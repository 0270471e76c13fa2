// The collision hulls of the meshes and unions of one level. A file stores a shape once for any
// number of parts, so it is decoded once. The memory of all parts together is bounded.
#pragma once

#include <unordered_map>
#include <vector>

#include "import/document/tree.h"
#include "import/draft/draft.h"
#include "import/format/csg_physics.h"

namespace obby::importer {

// Max corners of all hulls of a level together: 48 MB, and 64 MB in its record.
constexpr size_t kMaxLevelCorners = 4000000;

// Returns the corners times `scale`, axis by axis. Hulls that leave the bounds of a level are
// dropped.
std::vector<std::vector<Vec3>> scaledHulls(std::vector<std::vector<Vec3>> hulls, Vec3 scale);

// Decodes each shape once. The document of the parts must outlive this object.
class LevelHulls {
 public:
  // Gives a part its hulls. The part becomes its bounding box if they cannot be read, or if the
  // level would exceed kMaxLevelCorners. A hull with too many corners for a level becomes its
  // bounding box. `level` notes both.
  void give(const Tree& tree, PartDraft& part, LevelDraft& level);

 private:
  struct Known {
    Collision collision;  // hulls that a level can have, in the space of InitialSize
    size_t corners = 0;   // corners of all hulls together
    size_t boxed = 0;     // number of hulls replaced by boxes for too many corners
  };
  Known decoded(const CollisionBlob& blob) const;
  const Known& knownOf(const Instance& part);

  std::unordered_map<const char*, Known> shared_;  // hulls by the address of their bytes
  Known own_;                                      // hulls of the last part with unshared bytes
  size_t left_ = kMaxLevelCorners;
};

}  // namespace obby::importer
