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

  // Finds where each of at most kWideSlots worlds is in the grid, and how far it reaches. Must come
  // before the rest.
  void look(World* const* worlds, int count);

  bool running(int world) const { return looks_[world].running != 0; }

  // Lists the parts near a world of the last look() under `index`; false if lanes cannot handle
  // them, and the world must take tick().
  bool list(int world, int index);

  // Of what was listed last under `index`.
  int count(int index) const { return count_[index]; }
  uint32_t anyFlags(int index) const { return anyFlags_[index]; }
  const uint32_t* tags(int index) const { return tags_[index]; }  // (count), level::Bounds::tag

 private:
  // What a world is after: a row.
  struct alignas(64) Look {
    float reach[8];  // corners as level::Bounds has them, and two numbers that are never exceeded
    int32_t cell;    // of the grid; -1: none
    int32_t running;
    int32_t single;  // not 0: it climbs, or parts that it touched vanish
    int32_t unused[5];
  };
  static_assert(sizeof(Look) == 4 * kRowWords);

  const level::LevelView& level_;
  Look looks_[kWideSlots];
  const uint32_t* lists_[kWideSlots];
  uint8_t count_[kWideSlots];
  uint32_t anyFlags_[kWideSlots];
  alignas(64) uint32_t tags_[kWideSlots][kRowWords];
};

}  // namespace obby::sim
