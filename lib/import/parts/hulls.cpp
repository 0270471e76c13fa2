// Decodes hulls from collision blobs, within the level's budget.
#include "import/parts/hulls.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/document/pose_math.h"
#include "level/hull_tables.h"
#include "level/record_values.h"

namespace obby::importer {
namespace {

constexpr size_t kLeastCorners = 4, kMostCorners = 255;
constexpr const char* kKind = "shape of a mesh or union";  // kind in the level's list of losses

// Returns true if a level may have the corner. One corner beyond would get the whole level
// rejected.
bool isInBounds(Vec3 corner) {
  const Vec3 far = abs(corner);
  return isFinite(corner) && maxf(far.x, maxf(far.y, far.z)) <= level::kMaxCoordinate;
}

// Notes that some hulls of the part are boxes.
void noteBoxed(const Tree& tree, PartDraft& part, size_t boxed, LevelDraft& level) {
  const std::string what = fmt::format(
      "{} of {} hulls have more than {} corners; each of these becomes its bounding box", boxed,
      part.hulls.size(), kMostCorners);
  part.evidence.push_back({"shape", what, true});
  if (part.solid) level.noteUnmodelled(kKind, tree, part.id, what);
}

}  // namespace

std::vector<std::vector<Vec3>> scaledHulls(std::vector<std::vector<Vec3>> hulls, Vec3 scale) {
  for (auto& hull : hulls)
    for (Vec3& corner : hull) corner = mul(corner, scale);
  std::erase_if(hulls, [](const std::vector<Vec3>& hull) {
    return !std::all_of(hull.begin(), hull.end(), isInBounds);
  });
  return hulls;
}

LevelHulls::Known LevelHulls::decoded(const CollisionBlob& blob) const {
  Known known{collisionFrom(blob), 0, 0};
  auto& hulls = known.collision.hulls;
  std::erase_if(hulls, [](const std::vector<Vec3>& hull) { return hull.size() < kLeastCorners; });
  for (auto& hull : hulls) {
    if (hull.size() > kMostCorners) {
      hull = level::boxAround(hull);
      ++known.boxed;
    }
    known.corners += hull.size();
  }
  // Packed hulls are many times their size in the file, so the level's budget bounds them, too.
  if (known.corners > left_) hulls = {};
  return known;
}

const LevelHulls::Known& LevelHulls::knownOf(const Instance& part) {
  const CollisionBlob blob = collisionBlobOf(part);
  if (!blob.shared) {
    own_ = decoded(blob);
    return own_;
  }
  const auto [known, isNew] = shared_.try_emplace(blob.bytes.data());
  if (isNew) known->second = decoded(blob);
  return known->second;
}

void LevelHulls::give(const Tree& tree, PartDraft& part, LevelDraft& level) {
  const Instance& instance = tree.at(part.id);
  const Known& known = knownOf(instance);
  const bool fits = known.corners <= left_;
  if (fits && known.corners > 0) {
    part.hulls = scaledHulls(known.collision.hulls, hullScaleOf(instance));
    left_ -= known.corners;
    if (known.boxed > 0 && !part.hulls.empty()) noteBoxed(tree, part, known.boxed, level);
    if (!part.hulls.empty()) return;
  }
  part.shape = Shape::block;
  if (known.collision.kind == CollisionKind::Box) return;
  const std::string tooMany =
      fmt::format("the level's hulls have more than {} corners in total", kMaxLevelCorners);
  part.evidence.push_back(
      {"shape", "bounding box: " + (fits ? known.collision.detail : tooMany), true});
  if (part.solid)
    level.noteUnmodelled(
        kKind, tree, part.id,
        (fits ? "no readable collision hulls" : tooMany) + "; its bounding box is used");
}

}  // namespace obby::importer
