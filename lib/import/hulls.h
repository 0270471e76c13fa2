// The collision hulls of the meshes and unions of one level. A file stores a shape once for any
// number of parts, so it is decoded once, and what all parts take is bounded.
#pragma once

#include <unordered_map>
#include <vector>

#include "import/draft.h"
#include "import/format/csg_physics.h"
#include "import/tree.h"

namespace obby::importer {

// Corners of all hulls of a level together: 48 MB, and 64 MB in its record.
constexpr size_t kMaxLevelCorners = 4000000;

// Corners times `scale`, axis by axis; without the hulls that this takes out of the bounds of a
// level.
std::vector<std::vector<Vec3>> scaledHulls(std::vector<std::vector<Vec3>> hulls, Vec3 scale);

// The document of the parts must outlive it.
class LevelHulls {
 public:
  // Gives a part its hulls. Where they cannot be read, or those of the level would have more than
  // kMaxLevelCorners, it becomes its bounding box; a hull with more corners than a level takes
  // becomes the box around it. `level` notes both.
  void give(const Tree& tree, PartDraft& part, LevelDraft& level);

 private:
  struct Known {
    Collision collision;  // with hulls that a level can have, in the space of InitialSize
    size_t corners = 0;   // of them together
    size_t boxed = 0;     // how many of them are boxes around hulls of too many corners
  };
  Known decoded(const CollisionBlob& blob) const;
  const Known& knownOf(const Instance& part);

  std::unordered_map<const char*, Known> shared_;  // by the address of their bytes
  Known own_;                                      // of the last part whose bytes nothing shares
  size_t left_ = kMaxLevelCorners;
};

}  // namespace obby::importer
