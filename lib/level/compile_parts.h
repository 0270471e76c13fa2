// Parts of a record to colliders, roles, movers and clocks: the tables of LevelView before the grid
// is laid over them.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/hull_tables.h"
#include "level/level_view.h"
#include "level/motion_tables.h"
#include "schema/obby.capnp.h"

namespace obby::level {

struct PartTables {
  std::vector<Collider> colliders;
  std::vector<Bounds> bounds;  // (colliders + 1), see LevelView
  std::vector<Roles> roles;
  std::vector<Mover> movers;
  std::vector<Loose> loose;
  size_t fixedColliders = 0;  // those of loose parts come after them
  std::vector<Clock> clocks;  // each role's own, then those that parts share
  uint32_t crushClock = kNone;
  std::vector<std::string> names;    // (parts)
  std::deque<MotionTables> motions;  // what movers point into; a deque keeps addresses
  HullStore hulls;                   // what shapes point into
  bool timed = false;                // any part whose state depends on the clock
};

// Smallest extent that the engine's physics uses (docs/physics.md, parts).
constexpr float kMinSize = 0.05f;
constexpr float kMaxSize = 2048;
constexpr float kMaxFriction = 100;
constexpr uint32_t kMaxParts = 1000000;
// Rows of all motion tables of a level together: 200 MB.
constexpr size_t kMaxLevelRows = 4000000;

Result<PartTables> compileParts(schema::Level::Reader record, const Params& params);

}  // namespace obby::level
