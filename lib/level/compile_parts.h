// Parts of a record to colliders, roles, movers and clocks: the tables of LevelView before the grid
// is laid over them.
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
  std::vector<Loose> loose;
  size_t fixedColliders = 0;                      // those of loose parts come after them
  std::vector<Clock> clocks;                      // each role's own, then those that parts share
  uint32_t crushClock = kNone, airClock = kNone;  // those of LevelView
  std::vector<std::string> names;                 // (parts)
  std::deque<std::vector<Pose>> motions;          // tables of keys that movers point into
  SpinStore spins;                                // and their turns
  HullStore hulls;                                // what shapes point into
  bool timed = false;                             // any part whose state depends on the clock
};

constexpr uint32_t kMaxParts = 1000000;
// Rows of all motion tables of a level together: 200 MB.
constexpr size_t kMaxLevelRows = 4000000;
// Rows of one table: the first number with which all tables fit. With fewer of them a period that
// is no whole number of ticks is less exact, by at most half a tick a repetition.
constexpr uint32_t kMaxTableRows[] = {kMaxRows, kMaxRows / 4, kMaxRows / 16, kMaxRows / 64};

Result<PartTables> compileParts(schema::Level::Reader record, const Params& params);

}  // namespace obby::level
