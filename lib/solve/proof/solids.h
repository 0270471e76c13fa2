// The solid parts of a level and where bodies can be in and beside them: what pressing.cpp asks.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "solve/proof/body_reach.h"
#include "solve/proof/box_index.h"
#include "solve/proof/part_motion.h"

namespace obby::solve {

constexpr float kAnyDepth = 1e30f;  // studs

inline Box common(const Box& a, const Box& b) { return {max(a.lo, b.lo), min(a.hi, b.hi)}; }

// Of all parts of the level together.
inline uint32_t flagsOfAll(const level::LevelView& level) {
  uint32_t flags = 0;
  for (uint32_t i = 0; i < level.colliderCount; ++i) flags |= level.bounds[i].flags;
  return flags;
}

inline bool isSolid(const level::LevelView& level, uint32_t id) {
  return (level.bounds[id].flags & level::kSolid) != 0;
}
inline bool isUpright(const level::LevelView& level, uint32_t id) {
  return (level.bounds[id].flags & level::kUpright) != 0;
}
inline bool isStill(const level::LevelView& level, uint32_t id) {
  return isUpright(level, id) && (level.bounds[id].flags & level::kMoving) == 0;
}

// So far beside it and between those heights.
inline Box beside(const Box& box, float side, float lowest, float highest) {
  return {{box.lo.x - side, lowest, box.lo.z - side}, {box.hi.x + side, highest, box.hi.z + side}};
}

// Of a part with that box: the lowest that its top can be, and the highest that its underside can.
inline float lowestTop(const Box& box, bool still) { return still ? box.hi.y : box.lo.y; }
inline float highestUnderside(const Box& box, bool still) { return still ? box.lo.y : box.hi.y; }

// How far below the top of their floor feet can be whose legs are bent.
inline float deepestFeet(const Params& p) { return std::max(sim::rayHeight(p), p.hipHeight); }

// The level's solid parts, each wherever it can be.
class Solids {
 public:
  Solids(const level::LevelView& level, const std::vector<PartMotion>& motions)
      : level_(level), boxes_(boxesOf(level, motions)), index_(solidBoxes()) {}

  const Box& box(uint32_t id) const { return boxes_[id]; }
  bool isSolid(uint32_t id) const { return solve::isSolid(level_, id); }
  bool isUpright(uint32_t id) const { return solve::isUpright(level_, id); }
  bool isStill(uint32_t id) const { return solve::isStill(level_, id); }

  float lowestTop(uint32_t id) const { return solve::lowestTop(boxes_[id], isStill(id)); }
  float highestUnderside(uint32_t id) const {
    return solve::highestUnderside(boxes_[id], isStill(id));
  }

  // All of a body that touches the part is in it, fallen down too.
  Box touching(uint32_t id) const {
    const float side = bodyAcross(level_.params);
    return grow(boxes_[id], {side, level_.params.bodyTop + kSlack, side});
  }

  // No body is farther in a block than half of what both measure along any of its axes.
  float mostDepth(uint32_t id) const {
    if (!isUpright(id)) return kAnyDepth;
    const Vec3 half = level_.colliders[id].shape.half;
    const float aside = std::min(half.x, half.z) + 0.5f * bodyAcross(level_.params);
    return std::min(aside, half.y + 0.5f * level_.params.bodyTop);
  }

  // Somebody within `from` may be put out of the part: where all of the body is then.
  Box putOut(uint32_t id, const Box& from) const {
    const Box near = touching(id);
    const float most = mostDepth(id) + kSlack;
    return common(grow(common(from, near), {most, most, most}), near);
  }

  // Does one of them stand on the other, away from its rim, or pass through it? The one then puts
  // out aside, the other up or down, and neither puts anybody into the other.
  bool standOnEachOther(uint32_t a, uint32_t b, const Box& where) const {
    return stands(a, b, where) || stands(b, a, where);
  }

  // May the one, which stands on the other, put somebody down through that? So it may where it is
  // as high as a body is above its legs, and as wide, and the other is no thicker than a body.
  bool putsDown(uint32_t upper, uint32_t lower, const Box& where) const {
    if (!stands(upper, lower, where)) return false;
    const Params& p = level_.params;
    const float sunk = std::max(sim::rayHeight(p) - p.hipHeight, 0.0f);
    const float least = p.bodyTop - p.hipHeight - sunk - kSlack;  // studs down, to be below it
    const Box& box = boxes_[upper];
    const bool thin = 2 * level_.colliders[lower].shape.half.y < p.bodyTop;
    return thin && box.hi.y - box.lo.y > least && mostDepth(upper) > least;
  }

  // Is a part, other than `but`, where it can push down somebody whose feet are at `feet` or
  // higher, at most so far beside the box? `work` grows by what has been looked at.
  bool stopsHead(const Box& box, uint32_t but, float side, float feet, float highest,
                 size_t& work) const {
    const Params& p = level_.params;
    const float half = 0.5f * (p.hipHeight + p.bodyTop);
    const float above = feet + std::min(half, p.hipHeight + p.bodyTop - p.headBottom);
    bool found = false;
    work += find(beside(box, side, above, highest),
                 [&](uint32_t id) { found |= id != but && highestUnderside(id) > above; });
    return found;
  }

  template <class Found>
  size_t find(const Box& where, Found&& found) const {
    return index_.find(where, [&](uint32_t i) { found(ids_[i]); });
  }

 private:
  static std::vector<Box> boxesOf(const level::LevelView& level,
                                  const std::vector<PartMotion>& motions) {
    std::vector<Box> boxes;
    boxes.reserve(level.colliderCount);
    for (uint32_t id = 0; id < level.colliderCount; ++id) boxes.push_back(level.bounds[id].box());
    for (const PartMotion& m : motions) boxes[m.collider] = m.swept;
    return boxes;
  }

  std::vector<Box> solidBoxes() {
    std::vector<Box> boxes;
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (!isSolid(id)) continue;
      ids_.push_back(id);
      boxes.push_back(boxes_[id]);
    }
    return boxes;
  }

  bool stands(uint32_t upper, uint32_t lower, const Box& where) const {
    const level::Collider& c = level_.colliders[lower];
    if (!isUpright(lower) || c.mover != level::kNone) return false;
    const Box &above = boxes_[upper], &below = boxes_[lower];
    if (above.lo.y > below.hi.y + kSlack || above.hi.y < below.hi.y) return false;
    const Box body = common(where, touching(upper));
    const float rim = c.shape.half.y + 0.5f * level_.params.bodyTop;
    for (int corner = 0; corner < 4; ++corner) {
      const Vec3 at{(corner & 1) != 0 ? body.hi.x : body.lo.x, c.pose.position.y,
                    (corner & 2) != 0 ? body.hi.z : body.lo.z};
      const Vec3 local = abs(toLocal(c.pose, at));
      if (local.x + rim > c.shape.half.x || local.z + rim > c.shape.half.z) return false;
    }
    return true;
  }

  const level::LevelView& level_;
  std::vector<Box> boxes_;     // (colliders)
  std::vector<uint32_t> ids_;  // of the boxes in the index
  BoxIndex index_;
};

}  // namespace obby::solve
