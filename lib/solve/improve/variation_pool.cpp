#include "solve/improve/variation_pool.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr size_t kCapacity = 24;      // variations that are played side by side
constexpr double kMinGain = 1e-4;     // seconds; smaller gains are rounding
constexpr uint32_t kSettle = 30;      // points after a variation until it is compared with the line
constexpr double kMaxDeficit = 0.03;  // seconds that a variation may lag behind the line after that

}  // namespace

struct VariationPool::Member {
  std::shared_ptr<const GuidedLine> base;
  Variation variation;
  Follower follower;
  sim::World world;
  std::vector<sim::RigidBody> bodies;
  CostState cost;
  std::vector<sim::Action> played;
  uint32_t jumps = 0;  // before the tick

  bool isCheaper(const Line& best) const {
    return cost.cost < best.cost() + (variation.mayCostMore ? best.risk : 0) - kMinGain;
  }

  std::vector<sim::Action> actions() const {
    const auto& before = base->line.actions;
    std::vector<sim::Action> all(before.begin(), before.begin() + variation.start);
    all.insert(all.end(), played.begin(), played.end());
    return all;
  }
};

VariationPool::VariationPool(const Problem& problem, const CostMeter& meter)
    : problem_(problem), meter_(meter), lockstep_(problem) {}

VariationPool::~VariationPool() = default;

bool VariationPool::isFull() const { return members_.size() >= kCapacity; }

void VariationPool::add(std::shared_ptr<const GuidedLine> base, Variation variation) {
  const Line& line = base->line;
  const uint32_t start = variation.start;
  const auto bodies = line.bodiesAt(start);
  const sim::World& world = line.worlds[start];
  const sim::Action last = start > 0 ? line.actions[start - 1] : sim::Action{};
  const Follower follower(start, variation.settings, world, last);
  const CostState cost = line.costs[start];
  members_.push_back(std::make_unique<Member>(Member{std::move(base),
                                                     std::move(variation),
                                                     follower,
                                                     world,
                                                     {bodies.begin(), bodies.end()},
                                                     cost,
                                                     {}}));
}

// Ends variations that have failed, that cost too much, or that are back on the line without a
// gain.
bool VariationPool::goesOn(const Member& m, const Line& best) const {
  if (m.world.outcome != sim::Outcome::running || !m.isCheaper(best)) return false;
  const Guide& guide = m.variation.guide;
  const uint32_t at = m.follower.at();
  if (at < guide.tail + kSettle) return true;
  const int64_t tick = int64_t(at) + guide.tailShift;
  if (tick < 0 || tick > m.base->line.ticks()) return true;
  const double deficit = m.cost.cost - m.base->line.costs[size_t(tick)].cost;
  return deficit < kMaxDeficit + (m.variation.mayCostMore ? best.risk : 0);
}

std::vector<std::vector<sim::Action>> VariationPool::tick(const Line& best) {
  for (const auto& m : members_) {
    m->played.push_back(m->follower.next(m->variation.guide, m->world, problem_.level.params));
    m->jumps = m->world.jumps;
    lockstep_.add(m->world, m->bodies, m->played.back());
  }
  lockstep_.advance();
  std::vector<const Member*> better;
  for (const auto& m : members_) {
    const bool jumped = m->world.jumps > m->jumps;
    meter_.note(m->cost, m->played.back(), jumped, m->world, m->bodies.data());
    const bool solves = m->world.outcome == sim::Outcome::goal;
    if (solves && m->isCheaper(best)) better.push_back(m.get());
  }
  std::ranges::stable_sort(better, {}, [](const Member* m) { return m->cost.cost; });
  std::vector<std::vector<sim::Action>> found;
  for (const Member* m : better) found.push_back(m->actions());
  std::erase_if(members_, [&](const auto& m) { return !goesOn(*m, best); });
  return found;
}

}  // namespace obby::solve
