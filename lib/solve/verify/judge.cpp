#include "solve/verify/judge.h"

#include <algorithm>
#include <cmath>

namespace obby::solve {

Judge::Judge(schema::Query::Reader query, const level::LevelView& level) : level_(level) {
  level::ColliderRuns runs(level);
  const schema::Arrive arrive = query.getArrive();
  if (query.hasGoal()) goals_.emplace_back(query.getGoal(), runs, arrive, level);
  for (const auto goal : query.getGoals()) goals_.emplace_back(goal, runs, arrive, level);
  for (const auto visit : query.getVisits()) visits_.emplace_back(visit, runs, arrive, level);
  for (const auto avoid : query.getAvoid()) {
    avoid_.emplace_back(avoid, runs, schema::Arrive::TOUCH, level);
  }
  for (const auto w : query.getWaypoints()) {
    stops_.push_back({Place(w.getRegion(), runs, arrive, level),
                      w.getMaxJumps(),
                      ticksOf(w.getTimeLimit()),
                      {w.getSegmentJumps(), ticksOf(w.getSegmentTime())}});
  }
  last_ = {query.getSegmentJumps(), ticksOf(query.getSegmentTime())};
  for (const auto state : query.getForbid()) forbidden_.push_back(state);
  minJumps_ = query.getMinJumps();
  maxJumps_ = query.getMaxJumps();
  ticks_ = ticksOf(query.getTimeLimit());
  maxDamage_ = query.getMaxDamage();
  visited_.assign(visits_.size(), false);
}

int64_t Judge::ticksOf(float seconds) const {
  if (!(seconds > 0)) return -1;
  const double exact = double(seconds) * level_.params.controlRate;
  // The record's float may be half its last bit below a whole number of ticks. A limit beyond the
  // range of the level's clock is no limit.
  return int64_t(std::min(std::floor(exact + 1e-4 + exact * 0x1p-23), 4294967295.0));
}

bool Judge::tooManyJumps(int64_t jumps) const {
  const auto over = [](int64_t made, int64_t max) { return max >= 0 && made > max; };
  if (over(jumps, maxJumps_) || over(jumps - segmentJumps_, segment().jumps)) return true;
  return reached_ < stops_.size() && over(jumps, stops_[reached_].jumps);
}

bool Judge::tooLate(int64_t tick) const {
  const auto over = [](int64_t spent, int64_t max) { return max >= 0 && spent >= max; };
  if (over(tick, ticks_) || over(tick - segmentTick_, segment().ticks)) return true;
  return reached_ < stops_.size() && over(tick, stops_[reached_].ticks);
}

bool Judge::isForbidden(sim::State state) const {
  return std::any_of(forbidden_.begin(), forbidden_.end(),
                     [&](schema::PlayerState s) { return int(s) == int(state); });
}

bool Judge::atGoal(const sim::Moment& m) const {
  if (reached_ < stops_.size() || m.world.jumps < minJumps_) return false;
  if (std::find(visited_.begin(), visited_.end(), false) != visited_.end()) return false;
  return std::any_of(goals_.begin(), goals_.end(), [&](const Place& g) { return holds(g, m); });
}

// Notes the waypoints and visits that are reached now. Returns JUMPS if the player has jumped too
// often by then, and else RUNNING.
schema::Outcome Judge::reach(const sim::Moment& m) {
  while (reached_ < stops_.size() && holds(stops_[reached_].place, m)) {
    ++reached_;
    segmentTick_ = m.tick;
    segmentJumps_ = m.world.jumps;
    levelTick_ = m.world.tick;
    if (tooManyJumps(m.world.jumps)) return schema::Outcome::JUMPS;
  }
  for (size_t i = 0; i < visits_.size(); ++i) {
    if (!visited_[i] && holds(visits_[i], m)) visited_[i] = true;
  }
  return schema::Outcome::RUNNING;
}

schema::Outcome Judge::after(const sim::Moment& m) {
  for (size_t i = 0; i < avoid_.size(); ++i) {
    if (!avoid_[i].isEntered(level_, m.before, m.world, m.bodies)) continue;
    avoided_ = int64_t(i);
    return schema::Outcome::AVOIDED;
  }
  if (isForbidden(m.world.state)) return schema::Outcome::FORBIDDEN;
  if (maxDamage_ >= 0 && double(m.world.damage) > maxDamage_) return schema::Outcome::HURT;
  if (tooManyJumps(m.world.jumps)) return schema::Outcome::JUMPS;
  if (reach(m) == schema::Outcome::JUMPS) return schema::Outcome::JUMPS;
  if (atGoal(m)) return schema::Outcome::GOAL;
  return tooLate(m.tick) ? schema::Outcome::TIMEOUT : schema::Outcome::RUNNING;
}

void Judge::note(sim::World& world) const {
  world.waypoints = uint8_t(reached_);
  world.segmentTick = levelTick_;
  world.segmentJumps = uint16_t(segmentJumps_);
  for (size_t i = 0; i < visited_.size(); ++i) {
    if (visited_[i]) world.visited |= 1u << i;
  }
  if (avoided_ >= 0) world.part = uint32_t(avoided_);
}

}  // namespace obby::solve
