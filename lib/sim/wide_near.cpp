#include "sim/wide_near.h"

#include <algorithm>

#include "sim/wide_state.h"

namespace obby::sim {
namespace {

// Flags of parts that only tick() handles.
constexpr uint32_t kSingly = level::kVanishTimer | level::kClocked | level::kTruss |
                             level::kTriggered | level::kOneWay | level::kCrush;

// Flags of parts that matter even if only the limbs can meet them.
constexpr uint32_t kByLimbs = level::kTouchRoles | kSingly;

constexpr uint32_t kNoParts[3] = {0, ~0u, 0};  // an empty list

}  // namespace

// Returns the width of tickBounds() beyond the max of bodyReach() and the rays.
float WideNear::limbsWidthOf(const level::LevelView& level) {
  const Params& p = level.params;
  const Vec3 still{};
  const float all = tickBounds<float>(still, still, p).hi.x;
  const float diagonal = sqrtf32(p.bodyWidth * p.bodyWidth + p.bodyDepth * p.bodyDepth);
  const float body = maxf(0.5f, p.floorRaySpread) * diagonal;
  constexpr float kRounding = 0.05f;
  const float move = (level.maxSideSpeed + p.gravity * p.tickSeconds) * p.tickSeconds;
  return maxf(all - body - move - p.contactSkin - kRounding, 0.0f);
}

// Computes each world's grid cell and reach, kLanes worlds at a time.
void WideNear::findReach(World* const* worlds, int count) {
  for (int i = 0; i < count; i += kLanes) {
    const void* rows[kLanes];
    void* looks[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      rows[lane] = worlds[std::min(i + lane, count - 1)];
      looks[lane] = &looks_[i + lane];
    }
    const Rows world = loadRows(rows);
    const Vec3T<WideFloat> position = vectorAt(world, kPositionWord);
    const BoxT<WideFloat> reach =
        tickBounds<WideFloat>(position, vectorAt(world, kVelocityWord), level_.params);
    Rows out;
    putVector(out, 0, reach.hi);
    putVector(out, 3, -reach.lo);
    out.word[6] = out.word[7] = bitsOf(WideFloat(Reach::kAny));
    out.word[8] = cellOf<WideFloat>(level_.grid, position);
    out.word[9] = world.word[kStateWord] & int32_t(0xff000000);
    const WideMask holds =
        (world.word[kStateWord] & 0xff0000) >= WideInt(int32_t(State::climbing) << 16);
    constexpr int32_t kRemembered = 0xff00 | kArrived;
    out.word[10] = (world.word[kFlagsWord] & kRemembered) | select(holds, WideInt(1), WideInt(0));
    out.word[11] = world.word[kTickWord];
    storeRows(out, looks);
  }
}

// Returns true if a dynamic body is near the player. Otherwise the bodies move separately from the
// player (wide_bodies.h).
bool WideNear::nearBodies(int i, const RigidBody* bodies) const {
  const Box near = looks_[i].box();
  bool found = false;
  for (uint32_t b = 0; b < level_.bodyCount; ++b)
    found |= isNear(bodies[b], level_.bodies[b], near);
  return found;
}

void WideNear::look(World* const* worlds, const RigidBody* const* bodies, int count) {
  findReach(worlds, count);
  movedCount_ = 0;
  // All lists are prefetched before the first is read, so that many loads run at the same time.
  const uint32_t* lists[kWideSlots];
  for (int i = 0; i < count; ++i) {
    const int32_t cell = looks_[i].cell;
    lists[i] = cell < 0 ? kNoParts + 2 : level_.grid.lists + level_.grid.cells[cell];
    __builtin_prefetch(lists[i]);
  }
  for (int i = 0; i < count; ++i) {
    // Lanes do not support jumps in the air.
    turn_[i] = looks_[i].outcome != 0            ? Turn::ended
               : level_.airClock != level::kNone ? Turn::single
                                                 : list(i, lists[i]);
    if (level_.bodyCount == 0 || turn_[i] != Turn::lanes) continue;
    if (nearBodies(i, bodies[i])) turn_[i] = Turn::single;
  }
}

WideNear::Turn WideNear::list(int i, const uint32_t* list) {
  const uint32_t any = list[-2], every = list[-1], count = list[0];
  const bool plain = (any & kByLimbs) == 0 && (every & level::kBlock) != 0 && count <= kRowWords;
  return plain ? listPlain(i, list) : listAll(i, list);
}

// Handles lists of blocks that no limb can meet. The loop does not branch for each part: a
// mispredicted branch costs more than the rest.
WideNear::Turn WideNear::listPlain(int i, const uint32_t* list) {
  const Reach body = Reach(looks_[i].reach) - limbs_;
  const uint32_t count = list[0];
  uint32_t* const tags = tags_[i];
  uint32_t found = 0;
  for (uint32_t k = 1; k <= count; k += level::kListStep) {
    for (uint32_t j = k; j < k + level::kListStep; ++j) {
      const level::Bounds& b = level_.bounds[list[j]];
      tags[found] = b.tag;
      found += body.meets(b);
    }
  }
  count_[i] = uint8_t(found);
  anyFlags_[i] = 0;
  if (looks_[i].single != 0) return Turn::single;
  return (list[-2] & level::kMoving) == 0 || moveParts(i) ? Turn::lanes : Turn::single;
}

WideNear::Turn WideNear::listAll(int i, const uint32_t* list) {
  const Reach reach(looks_[i].reach), body = reach - limbs_;
  const uint32_t count = list[0];
  uint32_t found = 0, all = 0, some = 0, every = ~0u;
  for (uint32_t k = 1; k <= count; k += level::kListStep) {
    if (found + level::kListStep > kRowWords) return Turn::single;
    for (uint32_t j = k; j < k + level::kListStep; ++j) {
      const level::Bounds& b = level_.bounds[list[j]];
      const uint32_t hit = reach.meets(b);
      tags_[i][found] = b.tag;
      found += body.meets(b) | (hit & uint32_t((b.flags & kByLimbs) != 0));
      all += hit;
      some |= b.flags & (0 - hit);
      every &= b.flags | (hit - 1);
    }
  }
  count_[i] = uint8_t(found);
  anyFlags_[i] = some;
  const bool common = (some & kSingly) == 0 && (every & level::kBlock) != 0;
  // tick() tests at most kMaxMovingCandidates moving parts, and sets an overrun flag for more.
  const bool crowded = all > kMaxMovingCandidates;
  if (!common || crowded || looks_[i].single != 0) return Turn::single;
  return (some & level::kMoving) == 0 || moveParts(i) ? Turn::lanes : Turn::single;
}

// Moves the moving parts near a world to their present poses, and drops those that are not near
// after all. Returns false if there are too many.
bool WideNear::moveParts(int i) {
  const Box limbs = looks_[i].box(), body = grow(limbs, {-limbsWidth_, 0, -limbsWidth_});
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count_[i]; ++k) {
    uint32_t tag = tags_[i][k];
    if (tag & level::kMovingTag) {
      const uint32_t id = tag >> level::kTagShift;
      const level::Collider& c = level_.colliders[id];
      const Pose pose = moverPose(level_.movers[c.mover], looks_[i].tick + 1);
      const bool byLimbs = (level_.bounds[id].flags & kByLimbs) != 0;
      if (!overlaps(boundsOf(pose, c.shape.half), byLimbs ? limbs : body)) continue;
      if (movedCount_ == kMovedParts) return false;
      tag = uint32_t(movedCount_) << level::kTagShift | (tag & ((1u << level::kTagShift) - 1));
      moved_[movedCount_++] = {pose, c.shape.half, id};
    }
    tags_[i][kept++] = tag;
  }
  count_[i] = uint8_t(kept);
  return true;
}

}  // namespace obby::sim
