// What the clocks that touches start do to parts during a playthrough.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::view {

// A part that loses (or gets back) its collision during a playthrough.
struct PartEvent {
  uint32_t tick;  // since the start of the playthrough
  uint32_t part;
  bool solid;
};

// A triggered part starts to move, starts anew, or rests again.
struct MotionEvent {
  uint32_t tick;  // since the start of the playthrough
  uint32_t part;
  int64_t start;  // tick at which its motion is at its beginning, or kRests
};
constexpr int64_t kRests = -1;

// Of either kind, that are kept of a playthrough: one button may bring thousands of parts, for
// hours.
constexpr size_t kMostPartEvents = 1'000'000;

// In the order of ticks, those of a tick in the order of parts.
struct PartEvents {
  std::vector<PartEvent> events;
  std::vector<MotionEvent> motions;
  bool cut = false;  // of one kind there are more, from some tick on, which are left out
};

// `worlds`: every state of the playthrough. Takes a time that grows with its ticks and with what
// happens in it, not with the parts of the level. `most`: of either kind to be kept, whole ticks.
PartEvents partEventsOf(const std::vector<sim::World>& worlds, const level::LevelView& view,
                        size_t most = kMostPartEvents);

}  // namespace obby::view
