#include "solve/search/rollouts/companions.h"

#include <algorithm>

#include "level/player.h"
#include "sim/simulator.h"

namespace obby::solve {

namespace {

constexpr float kNear = 1;  // max studs between a companion and the search's player

}  // namespace

Companions::Companions(const Problem& problem, const ExploreContext& context, uint64_t seed)
    : problem_(problem), context_(context), seed_(seed) {
  if (empty()) return;
  Party start{{problem.start, problem.startBodies}};
  for (const Companion& c : problem.companions) start.push_back({c.start, c.startBodies});
  parties_.push_back(std::move(start));
}

void Companions::keep(uint32_t node, const Walk& walk) {
  parties_.resize(node + 1);
  parties_[node] = walk.party_;
}

Companions::Walk::Walk(const Companions& all, uint32_t parent, uint64_t rollout)
    : all_(all),
      party_(all.parties_[parent]),
      explorer_(all.seed_, rollout),
      runs_(rollout & kWarmStart ? &all.problem_.known[rollout & ~kWarmStart] : nullptr) {}

sim::Action Companions::Walk::next() {
  if (runs_ != nullptr) return cursor_.next(*runs_);
  Body& own = party_.front();
  return explorer_.next(all_.context_, own.world, own.bodies.data());
}

// Each companion holds the keys until its first tick at or after the end of the player's tick.
void Companions::Walk::press(const sim::Action& action) {
  const Problem& p = all_.problem_;
  Body& own = party_.front();
  const uint32_t rate = p.level.params.controlRate;
  const uint32_t end = own.world.tick - p.start.tick + 1;  // ticks since the start
  sim::advance(own.world, own.bodies.data(), p.level, &p.query, action);
  for (size_t i = 0; i < p.companions.size(); ++i) {
    const Companion& c = p.companions[i];
    Body& body = party_[i + 1];
    const uint32_t last = level::nextTickAtRate(end, rate, c.level.params.controlRate);
    while (body.world.outcome == sim::Outcome::running && body.world.tick - c.start.tick < last) {
      sim::advance(body.world, body.bodies.data(), c.level, &c.query, action);
    }
  }
}

bool Companions::Walk::near(const Body& other) const {
  const sim::World &own = party_.front().world, &w = other.world;
  if (w.outcome != own.outcome || w.waypoints != own.waypoints || w.visited != own.visited) {
    return false;
  }
  if (grounded(own) && !grounded(w)) return false;
  return length(w.position - own.position) <= kNear;
}

bool Companions::Walk::follow(uint32_t ticks) {
  for (; ticks_ < ticks; ++ticks_) press(next());
  return std::all_of(party_.begin() + 1, party_.end(), [this](const Body& b) { return near(b); });
}

}  // namespace obby::solve
