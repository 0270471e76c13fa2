// Stores where the level's clock matters, and which of the clocks that touches start matter at all.
// The level's clock matters near moving and timed parts, modulo the time after which they all
// repeat. Elsewhere a state is as good at any time.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "level/level_view.h"

namespace obby::solve {

constexpr uint32_t kNoClock = level::kNone;  // the clock does not matter here

// Plain spans, for device code.
struct ClockView {
  const uint32_t* periods = nullptr;  // (nx * ny * nz), ticks; 0: no short period; or kNoClock
  Vec3 origin;
  float inverseCell = 1;
  int32_t nx = 0, ny = 0, nz = 0;
  // (LevelView::clockCount), ticks per bin of each clock that touches start; 0: the clock does not
  // tell states apart.
  const uint32_t* bins = nullptr;
  uint32_t binCount = 0;
};

template <class Table>
OBBY_DEVICE void forTables(ClockView& c, Table&& table) {
  table(c.periods, size_t(c.nx) * c.ny * c.nz);
  table(c.bins, c.binCount);
}

// Returns the period of the clock at a place (ClockView::periods). Outside the map the clock does
// not matter.
OBBY_DEVICE uint32_t clockPeriodAt(const ClockView& view, Vec3 p) {
  const float x = (p.x - view.origin.x) * view.inverseCell;
  const float y = (p.y - view.origin.y) * view.inverseCell;
  const float z = (p.z - view.origin.z) * view.inverseCell;
  if (!(x >= 0 && y >= 0 && z >= 0 && x < float(view.nx) && y < float(view.ny) &&
        z < float(view.nz))) {
    return kNoClock;
  }
  return view.periods[(size_t(y) * size_t(view.nz) + size_t(z)) * size_t(view.nx) + size_t(x)];
}

}  // namespace obby::solve
