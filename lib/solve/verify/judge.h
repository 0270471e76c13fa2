// A query's rules in the verifier's own words: read from the query record, judged in double
// precision after every tick of a replay without rules. Shares nothing with sim/rules.h; that a
// limb touches a part is physics, and the simulator's to say.
#pragma once

#include <cstdint>
#include <vector>

#include "level/level_view.h"
#include "sim/simulator.h"
#include "solve/verify/place.h"

namespace obby::solve {

class Judge {
 public:
  // The level must outlive the judge.
  Judge(schema::Query::Reader query, const level::LevelView& level);

  // Every moment but the start, in order, for as long as the player is alive. Gives how the
  // playthrough ends there, or RUNNING.
  schema::Outcome after(const sim::Moment& m);

  // Writes what was reached, when, and what was entered that is to be avoided.
  void note(sim::World& world) const;

 private:
  struct Segment {
    int64_t jumps, ticks;  // at most; -1: any
  };
  struct Stop {
    Place place;
    int64_t jumps, ticks;  // since the start, at most; -1: any
    Segment segment;
  };

  int64_t ticksOf(float seconds) const;
  bool holds(const Place& place, const sim::Moment& m) const {
    return place.holds(level_, m.world, m.loose);
  }
  bool tooManyJumps(int64_t jumps) const;
  bool tooLate(int64_t tick) const;
  bool atGoal(const sim::Moment& m) const;
  bool isForbidden(sim::State state) const;
  schema::Outcome reach(const sim::Moment& m);
  const Segment& segment() const {
    return reached_ < stops_.size() ? stops_[reached_].segment : last_;
  }

  const level::LevelView& level_;
  std::vector<Place> goals_, visits_, avoid_;
  std::vector<Stop> stops_;  // the waypoints
  Segment last_;             // to the goal
  std::vector<schema::PlayerState> forbidden_;
  int64_t minJumps_, maxJumps_, ticks_;
  double maxDamage_;
  size_t reached_ = 0;  // stops
  std::vector<bool> visited_;
  int64_t segmentTick_ = 0, segmentJumps_ = 0;  // when the last stop was reached
  uint32_t levelTick_ = 0;                      // the level's clock then
  int64_t avoided_ = -1;
};

}  // namespace obby::solve
