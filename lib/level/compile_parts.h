// Compiles parts of a record to colliders, roles, movers and clocks: all tables of LevelView except
// the grid.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/hull_tables.h"
#include "level/level_view.h"
#include "level/spin_store.h"
#include "schema/obby.capnp.h"

namespace obby::level {

struct PartTables {
  std::vector<Collider> colliders;
  std::vector<Bounds> bounds;  // (colliders + 1), see LevelView
  std::vector<Roles> roles;
  std::vector<Mover> movers;
  std::vector<DynamicBody> bodies;
  size_t fixedColliders = 0;  // number of colliders that precede those of dynamic parts
  std::vector<Clock> clocks;  // each role's own clock, then the shared clocks
  // Clocks of LevelView::crushClock and LevelView::airClock.
  uint32_t crushClock = kNone, airClock = kNone;
  std::vector<std::string> names;         // (parts)
  std::deque<std::vector<Pose>> motions;  // tables of keys that movers point into
  SpinStore spins;                        // tables of turns that movers point into
  HullStore hulls;                        // hulls that shapes point into
  bool timed = false;                     // true if any part's state depends on the level's
                                          // clock
};

constexpr uint32_t kMaxParts = 1000000;
// Max rows of all motion tables of a level together: 200 MB.
constexpr size_t kMaxLevelRows = 4000000;
// Max rows of one table, tried in turn until all tables fit. With fewer rows, a period that is not
// a whole number of ticks is less exact, by at most half a tick per repetition.
constexpr uint32_t kMaxTableRows[] = {kMaxRows, kMaxRows / 4, kMaxRows / 16, kMaxRows / 64};

Result<PartTables> compileParts(schema::Level::Reader record, const Params& params);

}  // namespace obby::level
