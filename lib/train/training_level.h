// A training level with its query, compiled once and shared by the worlds that play it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "level/level.h"
#include "policy/surroundings.h"
#include "sim/simulator.h"
#include "train/guide.h"
#include "train/play.h"

namespace obby::train {

class TrainingLevel {
 public:
  // Rewards follow the query's route, or else the line from the start through the waypoints to the
  // goal. Errors: those of Level::compile and Query::compile; a route of one place, of more than
  // 4,096 places or out of the world's bounds; a difficulty outside 0 to 1.
  static Result<std::shared_ptr<const TrainingLevel>> make(schema::Level::Reader level,
                                                           schema::Query::Reader query);

  const std::string& name() const { return level_.name(); }  // name in the level record
  const policy::Scene& scene() const { return scene_; }
  const sim::World& start() const { return start_; }
  const std::vector<sim::RigidBody>& startBodies() const { return startBodies_; }
  const Guide& guide() const { return guide_; }
  // Valid while this object lives. `patience`: as EnvGroupSettings::patience.
  TrainingView view(float patience) const;
  // Hash of all data of the level, the same for any encoding.
  uint64_t hash() const { return hash_; }

 private:
  TrainingLevel(level::Level level, level::Query query, std::vector<Vec3> route, uint64_t hash);

  level::Level level_;
  level::Query query_;
  uint64_t hash_;
  policy::Surroundings surroundings_;
  // Data that the scene refers to.
  level::QueryView queryView_;
  policy::SurroundingsView around_;
  policy::Scene scene_;
  sim::World start_;
  std::vector<sim::RigidBody> startBodies_;
  Guide guide_;
};

// Returns the ticks after which an episode is cut: `patience` times the walking time of the route,
// plus ten seconds.
uint32_t maxTicksOf(const TrainingLevel& level, float patience);

// Error for callers that require a level, if the source returned none.
inline constexpr const char* kInterrupted = "interrupted while reading levels";

// A sequence of levels. Level `index` must be the same for every call from any thread.
class LevelSource {
 public:
  virtual ~LevelSource() = default;
  // `hardest`: max difficulty, 0 to 1, if the source knows difficulties. Returns null if the source
  // was told to stop or has no more, and then for all later calls.
  virtual Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index,
                                                             float hardest) const = 0;
  // Declares that no level before this one will be requested.
  virtual void past(uint64_t) const {}
  // Declares that no level will be requested. Calls that wait in level() return.
  virtual void end() const {}
};

}  // namespace obby::train
