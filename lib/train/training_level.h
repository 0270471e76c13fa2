// A level to learn on, with its query, compiled once and shared by the worlds that play it.
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
  // Rewards follow the query's way; where it names none, from the start through its waypoints to
  // its goal. Errors as of Level::compile and Query::compile; a way of one place, of more than
  // 4,096, or that leads out of the world; a difficulty beyond 0 to 1.
  static Result<std::shared_ptr<const TrainingLevel>> make(schema::Level::Reader level,
                                                           schema::Query::Reader query);

  const std::string& name() const { return level_.name(); }  // of the level record
  const policy::Scene& scene() const { return scene_; }
  const sim::World& start() const { return start_; }
  const std::vector<sim::LooseBody>& startLoose() const { return startLoose_; }
  const Guide& guide() const { return guide_; }
  // Valid while this object lives. `patience`: as EnvGroupSettings::patience.
  TrainingView view(float patience) const;
  uint64_t hash() const { return hash_; }  // of all that it was made from, whatever the encoding

 private:
  TrainingLevel(level::Level level, level::Query query, std::vector<Vec3> way, uint64_t hash);

  level::Level level_;
  level::Query query_;
  uint64_t hash_;
  policy::Surroundings surroundings_;
  // What the scene refers to.
  level::QueryView queryView_;
  policy::SurroundingsView around_;
  policy::Scene scene_;
  sim::World start_;
  std::vector<sim::LooseBody> startLoose_;
  Guide guide_;
};

// Ticks after which a playthrough is given up: `patience` times what walking the way takes, and ten
// seconds.
uint32_t mostTicksOf(const TrainingLevel& level, float patience);

// The error of who cannot do without the level that a source did not give.
inline constexpr const char* kInterrupted = "interrupted while reading levels";

// Levels without end. Level `index` must be the same whoever asks, whenever, from whichever thread.
class LevelSource {
 public:
  virtual ~LevelSource() = default;
  // `hardest`: difficulty that the level has at most, 0 to 1, where the source knows of any. Null:
  // the source was told to stop, or has no more, and will give none.
  virtual Result<std::shared_ptr<const TrainingLevel>> level(uint64_t index,
                                                             float hardest) const = 0;
  // No level before this one will be asked for any more.
  virtual void past(uint64_t) const {}
  // None will be asked for any more: who waits for one in level() need not.
  virtual void end() const {}
};

}  // namespace obby::train
