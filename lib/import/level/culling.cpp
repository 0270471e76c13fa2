// Finds stray parts: below the fall height, or beyond ten times the extent of the middle 90 % of
// all parts.
#include "import/level/culling.h"

#include <algorithm>

#include "import/document/tree.h"

namespace obby::importer {
namespace {

constexpr float kFarExtents = 10;    // multiples of the extent of the middle 90 %
constexpr float kLeastExtent = 500;  // studs; small levels may have distant pieces
constexpr float kFarthest = 1e6f;    // studs; single precision is too coarse beyond
constexpr double kLowQuantile = 0.05, kHighQuantile = 0.95;

Box boundsOfPart(const PartDraft& part) { return boundsOf(part.pose, part.size * 0.5f); }

struct Range {
  float lo, hi;
};

Range middle(std::vector<float> values) {
  const auto at = [&](double q) {
    const auto n = values.begin() + std::ptrdiff_t(q * double(values.size() - 1));
    std::nth_element(values.begin(), n, values.end());
    return *n;
  };
  const float lo = at(kLowQuantile), hi = at(kHighQuantile);
  const float reach = std::max(hi - lo, kLeastExtent) * kFarExtents;
  return {lo - reach, hi + reach};
}

Box playBox(const std::vector<PartDraft>& parts) {
  Range ranges[3];
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float> centres;
    for (const auto& part : parts) centres.push_back(component(part.pose.position, axis));
    ranges[axis] = middle(std::move(centres));
  }
  return {{ranges[0].lo, ranges[1].lo, ranges[2].lo}, {ranges[0].hi, ranges[1].hi, ranges[2].hi}};
}

}  // namespace

void cullStrays(LevelDraft& level, const Tree& tree) {
  if (level.parts.empty()) return;
  const Box play = playBox(level.parts);
  std::vector<PartDraft> kept;
  for (auto& part : level.parts) {
    const Box box = boundsOfPart(part);
    const bool below = box.hi.y < level.world.fallenPartsHeight;
    const Vec3 far = abs(part.pose.position);
    const bool inSpace = maxf(far.x, maxf(far.y, far.z)) < kFarthest;
    if (!below && inSpace && overlaps(box, play)) {
      kept.push_back(std::move(part));
      continue;
    }
    ++level.partsCulled;
    level.noteIgnored(below ? "part below the fall height" : "part far from the rest",
                      tree.path(part.id), "players never get there; left out");
  }
  level.parts = std::move(kept);
}

}  // namespace obby::importer
