// The parts near many worlds, and which of the worlds SIMD lanes can take. Part of the wide tick
// (wide_tick.h); host only.
#pragma once

#include "sim/candidates.h"
#include "simd/rows.h"

namespace obby::sim {

constexpr int kWideSlots = 256;  // worlds a block
static_assert(kWideSlots % kLanes == 0 && kRowWords <= kMaxCandidates);

class WideNear {
 public:
  explicit WideNear(const level::LevelView& level) : level_(level) {}

  // Who takes a world's tick.
  enum class Turn : uint8_t { ended, single, lanes };  // no one; tick(); SIMD lanes

  // Looks around each of at most kWideSlots worlds.
  void look(World* const* worlds, int count);

  // Of the i-th world of the last look().
  Turn turn(int i) const { return turn_[i]; }
  // Of worlds that go to the lanes.
  int count(int i) const { return count_[i]; }
  uint32_t anyFlags(int i) const { return anyFlags_[i]; }  // ColliderFlag bits
  const uint32_t* tags(int i) const { return tags_[i]; }   // (count), level::Bounds::tag

 private:
  // What a world is after: a row.
  struct alignas(64) Look {
    float reach[8];  // corners as level::Bounds has them, and two numbers that are never exceeded
    int32_t cell;    // of the grid; -1: none
    int32_t outcome, vanishing;
    int32_t unused[5];
  };
  static_assert(sizeof(Look) == 4 * kRowWords);

  void findReach(World* const* worlds, int count);
  Turn list(int i, const uint32_t* list);

  const level::LevelView& level_;
  Look looks_[kWideSlots];
  Turn turn_[kWideSlots];
  uint8_t count_[kWideSlots];
  uint32_t anyFlags_[kWideSlots];
  alignas(64) uint32_t tags_[kWideSlots][kRowWords];
};

}  // namespace obby::sim
