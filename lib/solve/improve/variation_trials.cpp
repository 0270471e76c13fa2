#include "solve/improve/variation_trials.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr double kMinGain = 1e-4;     // seconds; smaller gains are rounding
constexpr uint32_t kSettle = 20;      // points after a variation until it is compared with the line
constexpr double kMaxDeficit = 0.08;  // seconds that a variation may lag behind the line after that

}  // namespace

struct VariationTrials::Member {
  const Variation* variation;
  Follower follower;
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  CostState cost;
  std::vector<sim::Action> played;
  uint32_t jumps = 0;  // before the tick
};

// Stops variations that have failed, that cost more than the whole line, or that are back on the
// line without a gain.
bool VariationTrials::goesOn(const Line& line, const Member& m) const {
  if (m.world.outcome != sim::Outcome::running) return false;
  if (m.cost.cost >= line.cost() - kMinGain) return false;
  const Guide& guide = m.variation->guide;
  const uint32_t at = m.follower.at();
  if (at < guide.tail + kSettle) return true;
  const int64_t tick = int64_t(at) + guide.tailShift;
  if (tick < 0 || tick > line.ticks()) return true;
  return m.cost.cost < line.costs[size_t(tick)].cost + kMaxDeficit;
}

void VariationTrials::tick(std::vector<Member*>& running) {
  for (Member* m : running) {
    m->played.push_back(m->follower.next(m->variation->guide, m->world, problem_.level.params));
    m->jumps = m->world.jumps;
    lockstep_.add(m->world, m->bodies, m->played.back());
  }
  lockstep_.advance();
  for (Member* m : running) {
    const bool jumped = m->world.jumps > m->jumps;
    meter_.note(m->cost, m->played.back(), jumped, m->world, m->bodies.data());
  }
}

std::vector<std::vector<sim::Action>> VariationTrials::cheaper(
    const Line& line, const std::vector<Variation>& variations) {
  std::vector<Member> members;
  members.reserve(variations.size());
  for (const Variation& c : variations) {
    const auto bodies = line.bodiesAt(c.start);
    const sim::World& world = line.worlds[c.start];
    const sim::Action last = c.start > 0 ? line.actions[c.start - 1] : sim::Action{};
    members.push_back({&c,
                       Follower(c.start, c.settings, world, last),
                       world,
                       {bodies.begin(), bodies.end()},
                       line.costs[c.start],
                       {}});
  }
  std::vector<Member*> running;
  for (Member& m : members) running.push_back(&m);
  while (!running.empty()) {
    tick(running);
    std::erase_if(running, [&](const Member* m) { return !goesOn(line, *m); });
  }
  std::vector<const Member*> better;
  for (const Member& m : members) {
    const bool solves = m.world.outcome == sim::Outcome::goal;
    if (solves && m.cost.cost < line.cost() - kMinGain) better.push_back(&m);
  }
  std::ranges::stable_sort(better, {}, [](const Member* m) { return m->cost.cost; });
  std::vector<std::vector<sim::Action>> found;
  for (const Member* m : better) {
    found.emplace_back(line.actions.begin(), line.actions.begin() + m->variation->start);
    found.back().insert(found.back().end(), m->played.begin(), m->played.end());
  }
  return found;
}

}  // namespace obby::solve
