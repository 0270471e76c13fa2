// The parts near a place, as the policy reads them: for each square of ground, the colliders that a
// player there can see.
#pragma once

#include <stdint.h>

#include "level/level_view.h"

namespace obby::policy {

// Plain spans, for device code.
struct SurroundingsView {
  Vec3 origin;  // y is not used
  float inverseCell = 1;
  int32_t nx = 0, nz = 0;
  const uint32_t* starts = nullptr;   // (nx * nz + 1), into entries
  const uint32_t* entries = nullptr;  // colliders; sorted by lowest point within a square
  uint32_t entryCount = 0;
};

template <class Table>
OBBY_DEVICE void forTables(SurroundingsView& s, Table&& table) {
  table(s.starts, size_t(s.nx) * size_t(s.nz) + 1);
  table(s.entries, s.entryCount);
}

}  // namespace obby::policy
