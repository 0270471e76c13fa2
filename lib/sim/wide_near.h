// Finds the parts near many worlds, and the worlds that SIMD lanes can take. Part of the wide tick
// (wide_tick.h); host only.
#pragma once

#include "sim/candidates.h"
#include "sim/reach.h"
#include "simd/rows.h"

namespace obby::sim {

constexpr int kWideSlots = 256;  // worlds per block
static_assert(kWideSlots % kLanes == 0 && kRowWords <= kMaxCandidates);

// Pose of a moving part for a world. The row has the layout and the size of a level::Collider, so
// that finding a row takes no branch.
struct alignas(sizeof(level::Collider)) MovedPart {
  Pose pose;  // at the end of the tick
  Vec3 half;
  uint32_t collider;
};
static_assert(sizeof(MovedPart) == sizeof(level::Collider));

class WideNear {
 public:
  explicit WideNear(const level::LevelView& level)
      : level_(level),
        limbsWidth_(limbsWidthOf(level)),
        limbs_(Reach::sides(limbsWidth_)),
        rows_{reinterpret_cast<const char*>(level.colliders),
              reinterpret_cast<const char*>(moved_)} {}

  // The code that advances a world in this tick.
  enum class Turn : uint8_t { ended, single, lanes };  // none; tick(); SIMD lanes

  // Finds the parts around at most kWideSlots worlds. `bodies` may be null.
  void look(World* const* worlds, const RigidBody* const* bodies, int count);

  // The following are about the i-th world of the last look().
  Box reach(int i) const { return looks_[i].box(); }  // the space that the world's player can reach
  Turn turn(int i) const { return turn_[i]; }
  // These apply to worlds that go to the lanes. A part counts if the body or the floor rays can
  // meet it, or if the limbs can and a touch has an effect.
  int count(int i) const { return count_[i]; }
  // ColliderFlag bits of all parts in reach.
  uint32_t anyFlags(int i) const { return anyFlags_[i]; }
  // Returns the tags of these parts (level::Bounds::tag), (count). With kMovingTag the index is
  // that of a moved part.
  const uint32_t* tags(int i) const { return tags_[i]; }

  // Returns the collider of a tag.
  uint32_t colliderOf(uint32_t tag) const {
    const uint32_t index = tag >> level::kTagShift;
    return tag & level::kMovingTag ? moved_[index].collider : index;
  }
  // Returns pose and half extents as a row.
  const void* rowOf(uint32_t tag) const {
    return (tag & level::kMovingTag ? rows_[1] : rows_[0]) +
           size_t(tag >> level::kTagShift) * sizeof(MovedPart);
  }
  const Pose& poseOf(uint32_t tag) const { return *static_cast<const Pose*>(rowOf(tag)); }

 private:
  // The result for a world, as a row.
  struct alignas(64) Look {
    float reach[8];  // corners in the layout of level::Bounds, and two numbers that are never
                     // exceeded
    int32_t cell;    // cell of the grid; -1 for none
    int32_t outcome;
    int32_t single;  // not 0 if the player climbs, sits or was just teleported, or if a clock runs
    uint32_t tick;
    int32_t unused[4];

    Box box() const {
      return {-Vec3{reach[3], reach[4], reach[5]}, {reach[0], reach[1], reach[2]}};
    }
  };
  static_assert(sizeof(Look) == 4 * kRowWords);

  static float limbsWidthOf(const level::LevelView& level);
  void findReach(World* const* worlds, int count);
  // These list the parts near a world.
  Turn list(int i, const uint32_t* list);
  Turn listPlain(int i, const uint32_t* list);
  Turn listAll(int i, const uint32_t* list);
  bool moveParts(int i);
  bool nearBodies(int i, const RigidBody* bodies) const;

  const level::LevelView& level_;
  const float limbsWidth_;     // studs sideways that limbs reach beyond body and floor rays
  const Reach limbs_;          // limbsWidth_ as a Reach, to subtract from another
  const char* const rows_[2];  // tables of still and of moving parts
  Look looks_[kWideSlots];
  Turn turn_[kWideSlots];
  uint8_t count_[kWideSlots];
  uint32_t anyFlags_[kWideSlots];
  alignas(64) uint32_t tags_[kWideSlots][kRowWords];
  static constexpr int kMovedParts = 2 * kWideSlots;  // per block; worlds beyond them take tick()
  int movedCount_ = 0;
  union {  // leaves the array uninitialised
    MovedPart moved_[kMovedParts];
  };
};

}  // namespace obby::sim
