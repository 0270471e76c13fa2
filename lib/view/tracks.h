// Where moving parts are at each tick, as tables for the page: it knows no physics.
#pragma once

#include <cstdint>
#include <functional>

#include "level/level.h"
#include "view/poses.h"

namespace obby::view {

// Samples of one part for ticks 0, stride, 2 stride, ... Without positions it stays where the level
// has it, without rotations it keeps its own.
struct Track : Poses {
  uint32_t part = 0;
  bool triggered = false;  // ticks count from its start; a playthrough's motions say when that is
  uint32_t stride = 1;
  uint32_t count = 0;
  int32_t loopFrom = -1;  // sample that follows the last one; -1: the last one stays
  bool cut = false;       // its motion goes on behind the last sample
};

// Calls visit(track) for one track a moving part, one by one: all of a large level's may not fit
// into memory. Motion that repeats within `ticks` is stored once round; other motion is stored for
// `ticks` ticks. `stride`, a power of 2: every stride-th sample is kept, of a short round more.
void forTracks(const level::LevelView& level, uint32_t ticks, uint32_t stride,
               const std::function<void(const Track&)>& visit);

}  // namespace obby::view
