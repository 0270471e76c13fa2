#include "solve/proof/pressing.h"

#include <algorithm>
#include <utility>

#include "solve/proof/body_reach.h"

namespace obby::solve {

namespace {

// Somebody between two parts that are farther apart touches but one of them, at any facing.
float bodyAcross(const Params& p) { return length(Vec3{p.bodyWidth, 0, p.bodyDepth}) + kSlack; }
float torsoHeight(const Params& p) { return p.bodyTop - p.hipHeight; }

// Whoever is pressed touches both parts. The way out of `low` is the shortest one: sideways past
// `other`, or up. Not above 0: nobody touches both.
float pressDepth(const Params& p, const Box& low, const Box& other) {
  const float x = std::min(low.hi.x - other.lo.x, other.hi.x - low.lo.x);
  const float z = std::min(low.hi.z - other.lo.z, other.hi.z - low.lo.z);
  return std::min(std::min(x, z) + bodyAcross(p), low.hi.y - other.lo.y + torsoHeight(p));
}

class Presser {
 public:
  Presser(const level::LevelView& level, const std::vector<PartMotion>& motions) : level_(level) {
    found_.depth.assign(level.colliderCount, 0.0f);
    found_.presses.assign(level.colliderCount, false);
    boxes_.reserve(level.colliderCount);
    for (uint32_t id = 0; id < level.colliderCount; ++id) {
      boxes_.push_back(level.bounds[id].box());
    }
    for (const PartMotion& m : motions) boxes_[m.collider] = m.swept;
  }

  void note(uint32_t slider) {
    if (!isSolid(slider)) return;
    const float side = bodyAcross(level_.params), height = torsoHeight(level_.params);
    const Box near = grow(boxes_[slider], {side, height, side});
    for (uint32_t part = 0; part < level_.colliderCount; ++part) {
      if (!overlaps(near, boxes_[part]) || part == slider || !isSolid(part)) continue;
      const bool pressed = lift(slider, part), lifted = lift(part, slider);
      if (pressed || lifted) found_.presses[slider] = true;
    }
  }

  Pressing take() { return std::move(found_); }

 private:
  bool isSolid(uint32_t id) const { return (level_.bounds[id].flags & level::kSolid) != 0; }

  // Each pushes along the shortest way out of it: of two parts only the lower one pushes up. False:
  // nobody is lifted by `low`.
  bool lift(uint32_t low, uint32_t other) {
    const Box &box = boxes_[low], &beside = boxes_[other];
    const bool upright = (level_.bounds[low].flags & level::kUpright) != 0;
    if ((upright ? box.hi.y - kSlack : box.lo.y) > beside.hi.y) return false;
    const float depth = pressDepth(level_.params, box, beside);
    if (!(depth > 0)) return false;
    found_.depth[low] = std::max(found_.depth[low], depth);
    return true;
  }

  const level::LevelView& level_;
  std::vector<Box> boxes_;  // (colliders): where each can be
  Pressing found_;
};

}  // namespace

Pressing pressingOf(const level::LevelView& level, const std::vector<PartMotion>& motions) {
  Presser presser(level, motions);
  for (const PartMotion& m : motions) {
    if (m.sideways > 0) presser.note(m.collider);
  }
  return presser.take();
}

}  // namespace obby::solve
