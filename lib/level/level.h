// Compiles level and query records into the immutable form that the simulator reads. All validation
// of meaning happens here; io checks only form. Errors name the path in the record and the remedy.
//
//   OBBY_ASSIGN(const auto level, level::Level::compile(levelRecord));
//   OBBY_ASSIGN(const auto query, level::Query::compile(queryRecord, level));
//   sim::World world = sim::makeWorld(level.view(), query.start());
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "level/compile_params.h"
#include "level/query_view.h"
#include "schema/obby.capnp.h"

namespace obby::level {

// A pose and a time at which play can start.
struct StartPose {
  Vec3 feet;          // studs
  float yaw = 0;      // radians; 0 looks along -Z
  uint32_t tick = 0;  // level clock
};

// Immutable, and safe to share between threads. References that it returns, and the view's tables,
// stay valid while the level lives, even if it is moved.
class Level {
 public:
  // Errors have `path` set, e.g. "parts[88].size". More than 1 million parts are an error, and so
  // is a motion whose repetition takes longer than 20 minutes.
  static Result<Level> compile(schema::Level::Reader record);

  Level(Level&&) noexcept;
  Level& operator=(Level&&) noexcept;
  ~Level();

  const LevelView& view() const;
  const std::string& name() const;
  uint64_t hash() const;   // digest of everything that can change a trajectory
  bool hasMotion() const;  // true if moving or timed parts make the outcome depend on the clock
  uint32_t motionPeriod()
      const;  // ticks after which all motion repeats; 0 without motion, or for more than 2^20 ticks
  size_t partCount() const;
  const std::string& partName(uint32_t part) const;  // part < partCount(); may be empty
  const std::vector<StartPose>& spawns() const;      // in the record's order; may be empty
  Box bounds() const;  // bounds of all colliders, with their motion; a point at 0 if there are none

 private:
  struct Impl;
  explicit Level(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// A compiled query, which owns its regions. The level need not outlive this object.
class Query {
 public:
  // Places that the record names must be resolved (resolve_places.h). Errors have `path` set,
  // relative to the query.
  static Result<Query> compile(schema::Query::Reader record, const Level& level);

  QueryView view() const;  // valid while this object lives
  const std::string& id() const { return id_; }
  const StartPose& start() const { return start_; }

 private:
  std::string id_;
  StartPose start_;
  std::vector<TargetView> goals_;  // the first is QueryView::goal
  std::vector<WaypointView> waypoints_;
  std::vector<TargetView> visits_, avoid_;
  std::vector<uint32_t> touched_;
  QueryView limits_;  // the view without its lists
};

}  // namespace obby::level
