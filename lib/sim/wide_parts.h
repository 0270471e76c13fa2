// The parts near kLanes worlds: floors under the players, and parts that their bodies can meet.
// Part of the wide tick (wide_tick.h); host only.
#pragma once

#include "sim/wide_contact.h"
#include "sim/wide_near.h"

namespace obby::sim {

// Solid parts that one body can meet during a tick. Lanes cannot take a body with more than
// kLaneSolids.
struct LaneSolids {
  int32_t count;
  uint32_t tags[kLaneSolids];
};

class WideParts {
 public:
  WideParts(const level::LevelView& level, const WideNear& near) : level_(level), near_(near) {}

  // Loads the parts of kLanes worlds of near's last look. `index` (kLanes) selects the worlds, the
  // one with the most parts last. It must stay valid until the next call.
  void look(const int32_t* index);

  // These functions apply to the worlds of the last look(). `worlds` are all worlds of the block.
  FloorT<WideFloat> floorUnder(const WidePlayer& player, World* const* worlds) const;
  void findSolids(const WideMotion& motion, LaneSolids* solids) const;  // (kLanes)

  // Accepts any worlds of near's last look. `solids` has kLanes entries.
  Obstacles obstacles(const LaneSolids* const* solids) const;

 private:
  void addSurface(WideInt nearest, World* const* worlds, FloorT<WideFloat>& floor) const;

  const level::LevelView& level_;
  const WideNear& near_;
  const int32_t* index_ = nullptr;
  int count_ = 0;
  // Unions leave the arrays uninitialised, because zeroing them in every call is slow.
  union {
    WideBlock blocks_[kRowWords];
  };
  union {
    WideInt tags_[kRowWords];
  };
};

}  // namespace obby::sim
