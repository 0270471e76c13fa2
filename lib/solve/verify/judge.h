// A query's rules in the verifier's own code: read from the query record, and judged in double
// precision after every tick of a replay without rules. It shares nothing with sim/rules.h. The
// simulator still decides if a limb touches a part, since that is physics.
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

  // Must be called with every moment but the start, in order, while the player is alive. Returns
  // the outcome at that moment, or RUNNING.
  schema::Outcome after(const sim::Moment& m);

  // Writes the targets that were reached, with their times, and the avoid region that was entered.
  void note(sim::World& world) const;

 private:
  struct Segment {
    int64_t jumps, ticks;  // max; -1: any
  };
  struct Stop {
    Place place;
    int64_t jumps, ticks;  // max since the start; -1: any
    Segment segment;
  };

  int64_t ticksOf(float seconds) const;
  bool holds(const Place& place, const sim::Moment& m) const {
    return place.holds(level_, m.world, m.bodies);
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
  Segment last_;             // segment from the last stop to the goal
  std::vector<schema::PlayerState> forbidden_;
  int64_t minJumps_, maxJumps_, ticks_;
  double maxDamage_;
  size_t reached_ = 0;  // number of stops reached
  std::vector<bool> visited_;
  int64_t segmentTick_ = 0, segmentJumps_ = 0;  // at the last reached stop
  uint32_t levelTick_ = 0;                      // the level's clock at that time
  int64_t avoided_ = -1;
};

}  // namespace obby::solve
