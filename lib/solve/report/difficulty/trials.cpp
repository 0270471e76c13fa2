#include "solve/report/difficulty/trials.h"

#include "sim/carrier.h"

namespace obby::solve {

void Trials::add(NoisyPlayer player, Vec3 offset) {
  const auto recorded = rest_.course.replay.bodiesAtTick(rest_.segment.start);
  sim::World world = rest_.at(0);
  if (!(offset == Vec3{})) {
    const level::LevelView& level = rest_.problem.level;
    const uint32_t carrier = sim::carrierOf(world, recorded.data(), level);
    sim::World moved = world;
    moved.position += offset;
    const bool onLegs = world.state == sim::State::running || world.state == sim::State::landed;
    if (onLegs && sim::carrierOf(moved, recorded.data(), level) == carrier) world = moved;
  }
  members_.push_back({std::move(player), world});
  bodies_.insert(bodies_.end(), recorded.begin(), recorded.end());
}

sim::RigidBody* Trials::bodiesOf(size_t member) {
  const uint32_t count = rest_.problem.level.bodyCount;
  return count == 0 ? nullptr : &bodies_[member * count];
}

void Trials::tick() {
  worlds_.clear();
  bodyPointers_.clear();
  actions_.clear();
  for (const size_t i : playing_) {
    worlds_.push_back(&members_[i].world);
    bodyPointers_.push_back(bodiesOf(i));
    actions_.push_back(members_[i].player.next(members_[i].world));
  }
  sim::advanceAll(rest_.problem.level, &rest_.problem.query, worlds_, bodyPointers_.data(),
                  actions_.data());
}

// A player who arrives at the end of the segment must stay for kMinStay ticks to pass.
void Trials::judge(Member& m, sim::RigidBody* bodies) const {
  if (m.world.outcome != sim::Outcome::running) {
    m.fate = m.world.outcome == sim::Outcome::goal ? Fate::passed : Fate::failed;
    return;
  }
  m.stays = rest_.arrivesIn(m.world, bodies) ? m.stays + 1 : 0;
  if (m.stays >= kMinStay) m.fate = Fate::passed;
}

std::vector<bool> Trials::run() {
  for (size_t i = 0; i < members_.size(); ++i) playing_.push_back(i);
  for (uint32_t ticks = 1; ticks <= rest_.timeout && !playing_.empty(); ++ticks) {
    tick();
    for (const size_t i : playing_) judge(members_[i], bodiesOf(i));
    std::erase_if(playing_, [this](size_t i) { return members_[i].fate != Fate::playing; });
  }
  std::vector<bool> passed;
  for (const Member& m : members_) passed.push_back(m.fate == Fate::passed);
  return passed;
}

}  // namespace obby::solve
