#include "solve/report/difficulty/noisy_player.h"

#include <algorithm>

#include "nn/normal.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

namespace {

constexpr float kSteadily = 0.75f;   // share of walkSpeed; above it a place error counts as a lag
constexpr float kNearEnough = 0.3f;  // studs; a player this close takes no step
constexpr float kTurnsPerDegree = 65536.0f / 360;

int32_t nearest(float v) { return int32_t(v + (v < 0 ? -0.5f : 0.5f)); }

Vec3 flat(Vec3 v) { return {v.x, 0, v.z}; }

}  // namespace

NoisyPlayer::NoisyPlayer(const LastSegments& rest, const NoiseModel& model,
                         std::span<const int32_t> shifts)
    : rest_(&rest),
      model_(model),
      presses_(rest.jumps),
      holdTicks_(std::max(nearest(ticksOf(model.hold)), 1)),
      lookEvery_(std::max(nearest(ticksOf(model.reaction)), 1)) {
  for (size_t i = 0; i < shifts.size(); ++i) presses_[i] += shifts[i];
}

NoisyPlayer::NoisyPlayer(const LastSegments& rest, const NoiseModel& model,
                         std::span<const int32_t> shifts, const Random& random)
    : NoisyPlayer(rest, model, shifts) {
  noisy_ = true;
  random_ = random;
  for (int32_t& press : presses_) press += late();
  if (rest.setsOff) lag_ = late();
}

int32_t NoisyPlayer::late() { return nearest(nn::normal(random_) * ticksOf(model_.press)); }

// Decides what to do until the next look. A walking player who is ahead or behind only shifts the
// times of the keys, since the path stays the same. A player off the path, or at rest, walks back
// to it.
void NoisyPlayer::look(const sim::World& world) {
  const sim::World& recorded = rest_->at(place());
  const Vec3 off = flat(world.position - recorded.position);
  // At the start the player had time to look, so the first correction is immediate.
  decided_ = tick_ == 0 ? -off : -(seen_ + decided_);
  seen_ = off;
  sideways_ = decided_;
  const Vec3 velocity = flat(recorded.velocity);
  const float speed = length(velocity);
  const bool walks = rest_->actionAt(place()).walk;
  if (walks && speed > kSteadily * rest_->problem.level.params.walkSpeed) {
    const Vec3 ahead = velocity * (1.0f / speed);
    const float behind = dot(decided_, ahead);
    sideways_ -= ahead * behind;
    lag_ += std::clamp(nearest(ticksOf(behind / speed)), -lookEvery_, lookEvery_);
  }
  if (noisy_) {
    aside_ = Turns(nearest(nn::normal(random_) * model_.aim * kTurnsPerDegree));
  }
}

sim::Action NoisyPlayer::walk(const sim::World& world) const {
  sim::Action action = rest_->actionAt(place());
  action.jump = false;
  if (!action.walk) return hold(world);
  if (dot(sideways_, sideways_) > 0) {
    const Params& p = rest_->problem.level.params;
    const Vec3 along =
        directionOf(sinCos(action.heading)) * (p.walkSpeed * float(lookEvery_) * p.tickSeconds);
    action.heading = headingOf(along.x + sideways_.x, along.z + sideways_.z);
  }
  action.heading = Turns(action.heading + aside_);
  return action;
}

// The recorded player releases the keys here, and the noisy one walks to that player's position. No
// walk is needed if that position is less than a step away, or if momentum leads there anyway.
sim::Action NoisyPlayer::hold(const sim::World& world) const {
  const Vec3 to = flat(rest_->at(place()).position - world.position);
  const float speed2 = dot(flat(world.velocity), flat(world.velocity));
  const float distance = length(to), brake = 2 * rest_->problem.level.params.airAccel;
  if (distance < kNearEnough || (!grounded(world) && brake * distance < speed2)) return {};
  return {Turns(headingOf(to.x, to.z) + aside_), true, false};
}

bool NoisyPlayer::jumps(const sim::World& world) {
  if (pressed_ == presses_.size()) return false;
  if (held_ == 0) {
    const int32_t since = place() - presses_[pressed_];
    if (since < 0) return false;
    jumped_ = world.jumps;
    if (tick_ == 0) held_ = since;  // pressed before the segment began
  }
  // The key is released once it has worked, or it might cause two jumps.
  const bool over = world.jumps != jumped_ || held_ >= holdTicks_;
  held_ = over ? 0 : held_ + 1;
  pressed_ += over ? 1 : 0;
  return !over;
}

sim::Action NoisyPlayer::next(const sim::World& world) {
  if (int32_t(tick_) % lookEvery_ == 0) look(world);
  sim::Action action = walk(world);
  action.jump = jumps(world);
  ++tick_;
  return action;
}

}  // namespace obby::solve
