// Poses of moving parts at each tick, as tables for the page, which has no physics.
#pragma once

#include <cstdint>
#include <functional>

#include "level/level.h"
#include "view/poses.h"

namespace obby::view {

// Samples of one part at ticks 0, stride, 2 stride, ... Empty positions or rotations mean those of
// the level.
struct Track : Poses {
  uint32_t part = 0;
  // Ticks count from the motion's start, which a trajectory's motion events give.
  bool triggered = false;
  uint32_t stride = 1;
  uint32_t count = 0;
  int32_t loopFrom = -1;  // index of the sample after the last one; -1: the last one stays
  bool cut = false;       // the motion goes on after the last sample
};

// Calls visit(track) for each moving part, one by one, because all tracks of a large level may not
// fit into memory. Motion that repeats within `ticks` is stored for one period, other motion for
// `ticks` ticks. `stride`, a power of 2: every stride-th sample is kept, or more of a short period.
void forTracks(const level::LevelView& level, uint32_t ticks, uint32_t stride,
               const std::function<void(const Track&)>& visit);

}  // namespace obby::view
