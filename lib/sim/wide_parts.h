// The parts near kLanes worlds: what the players stand on, and what their bodies can meet. Part of
// the wide tick (wide_tick.h); host only.
#pragma once

#include "sim/wide_contact.h"
#include "sim/wide_near.h"

namespace obby::sim {

// Solid parts that one body can meet during a tick. More than kLaneSolids: not for the lanes.
struct LaneSolids {
  int32_t count;
  uint32_t tags[kLaneSolids];
};

class WideParts {
 public:
  WideParts(const level::LevelView& level, const WideNear& near) : level_(level), near_(near) {}

  // Looks at the parts of worlds of near's last look. `index`: (kLanes), which; the last has as
  // many parts as any. It must stay until the next call.
  void look(const int32_t* index);

  // For the worlds last looked at. `worlds`: all worlds of the block.
  FloorT<WideFloat> floorUnder(const WidePlayer& player, World* const* worlds) const;
  void findSolids(const WideMotion& motion, LaneSolids* solids) const;  // (kLanes)

  // For any worlds of near's last look. `solids`: (kLanes).
  Obstacles obstacles(const LaneSolids* const* solids) const;

 private:
  void addSurface(WideInt nearest, World* const* worlds, FloorT<WideFloat>& floor) const;

  const level::LevelView& level_;
  const WideNear& near_;
  const int32_t* index_ = nullptr;
  int count_ = 0;
  // Unions keep the arrays from being zeroed for every call.
  union {
    WideBlock blocks_[kRowWords];
  };
  union {
    WideInt tags_[kRowWords];
  };
};

}  // namespace obby::sim
