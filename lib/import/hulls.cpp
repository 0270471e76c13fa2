// Hulls from collision blobs, within the level's budget.
#include "import/hulls.h"

#include <fmt/format.h>

#include <algorithm>

#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr size_t kLeastCorners = 4, kMostCorners = 255;

}  // namespace

std::vector<std::vector<Vec3>> scaledHulls(std::vector<std::vector<Vec3>> hulls, Vec3 scale) {
  for (auto& hull : hulls)
    for (Vec3& corner : hull) corner = mul(corner, scale);
  std::erase_if(hulls, [](const std::vector<Vec3>& hull) {
    return !std::all_of(hull.begin(), hull.end(), isFinite);
  });
  return hulls;
}

LevelHulls::Known LevelHulls::decoded(const CollisionBlob& blob) {
  Known known{collisionFrom(blob), 0};
  auto& hulls = known.collision.hulls;
  std::erase_if(hulls, [](const std::vector<Vec3>& hull) {
    return hull.size() < kLeastCorners || hull.size() > kMostCorners;
  });
  for (const auto& hull : hulls) known.corners += hull.size();
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
    if (!part.hulls.empty()) return;
  }
  part.shape = Shape::block;
  if (known.collision.kind == CollisionKind::Box) return;
  const std::string tooMany =
      fmt::format("all hulls of the level have more than {} corners", kMaxLevelCorners);
  part.evidence.push_back(
      {"shape", "bounding box: " + (fits ? known.collision.detail : tooMany), true});
  if (part.solid)
    level.noteUnmodelled(
        "shape of a mesh or union", tree.path(part.id),
        (fits ? "no collision hulls that can be read" : tooMany) + "; its bounding box is taken");
}

}  // namespace obby::importer
