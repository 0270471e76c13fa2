#include "solve/improve/follower.h"

#include <algorithm>

#include "sim/player.h"
#include "solve/search/rollouts/explore_context.h"

namespace obby::solve {

namespace {

constexpr uint32_t kWindow = 24;        // points ahead among which the nearest is looked for
constexpr float kHeightShare = 0.1f;    // weight of height in the distance to a point
constexpr uint32_t kJumpPatience = 12;  // ticks
constexpr uint32_t kBeyondLanding = 3;  // points beyond the landing at which a jump aims
constexpr uint32_t kBeyondLaunch = 2;   // points beyond the launch at which a run-up aims
constexpr float kArrived = 0.3f;        // studs

float flatSquared(Vec3 v) { return v.x * v.x + v.z * v.z; }

}  // namespace

Follower::Follower(uint32_t start, const FollowSettings& settings, const sim::World& world,
                   const sim::Action& last)
    : settings_(settings), at_(start), jumps_(world.jumps), held_(last) {
  held_.jump = false;
}

uint32_t Follower::nearest(Vec3 position) const {
  uint32_t best = at_;
  float least = 1e30f;
  const uint32_t end = std::min(at_ + kWindow, guide_->last());
  for (uint32_t i = at_; i <= end; ++i) {
    const Vec3 to = guide_->points[i].position - position;
    const float distance = flatSquared(to) + kHeightShare * to.y * to.y;
    if (distance > least) continue;
    least = distance;
    best = i;
    // A jump or keys to repeat must not be passed over.
    if (i > at_ && (guide_->points[i].marks & kGuideRepeat)) break;
  }
  return best;
}

void Follower::advance(const sim::World& w) {
  if (first_) {
    first_ = false;
    if (here().marks & kGuideJump) pending_ = kJumpPatience;
    return;
  }
  const uint32_t before = at_;
  const bool byTime = settings_.synced || (here().marks & kGuideRepeat) != 0;
  at_ = byTime ? std::min(at_ + 1, guide_->last()) : nearest(w.position);
  if (before < at_ && guide_->nextJump[before + 1] <= at_) pending_ = kJumpPatience;
}

bool Follower::wantsJump(const sim::World& w, bool onGround) {
  if (w.jumps > jumps_) pending_ = 0;
  jumps_ = w.jumps;
  const bool atEdge = (here().marks & kGuideEdgeJump) != 0 && w.state == sim::State::running &&
                      w.floorlessSteps > 0;
  const bool wanted = pending_ > 0;
  if (wanted) --pending_;
  return (wanted && onGround) || atEdge;
}

uint32_t Follower::aim(bool onGround) const {
  const uint32_t last = guide_->last();
  const auto upTo = [&](uint32_t i, uint32_t more) { return std::min(i + more, last); };
  if (!onGround && !settings_.synced) {
    const uint32_t from = upTo(at_, 1);
    return upTo(std::min(guide_->nextGround[from], last), kBeyondLanding);
  }
  uint32_t target = upTo(at_, settings_.lookahead);
  const uint32_t jump = guide_->nextJump[upTo(at_, 1)];
  if (jump <= target && pending_ == 0) target = upTo(jump, kBeyondLaunch);
  return target;
}

void Follower::steer(const sim::World& w, bool onGround, const Params& params) {
  uint32_t target = aim(onGround);
  Vec3 to = guide_->points[target].position - w.position;
  while (!settings_.synced && target < guide_->last() && flatSquared(to) < kArrived * kArrived)
    to = guide_->points[++target].position - w.position;
  const float distance = sqrtf32(flatSquared(to));
  const float speed2 = flatSquared(w.velocity);
  held_.walk =
      onGround ? distance > kArrived || !settings_.synced : 2 * params.airAccel * distance > speed2;
  if (!held_.walk) {
    held_.heading = 0;
    return;
  }
  const Turns wanted = headingOf(to.x, to.z);
  const int off = int16_t(Turns(wanted - held_.heading));
  if (off > settings_.slack || off < -settings_.slack)
    held_.heading = Turns(sim::walkableHeading<int32_t>(wanted, params));
}

sim::Action Follower::next(const Guide& guide, const sim::World& w, const Params& params) {
  guide_ = &guide;
  const bool onGround = grounded(w);
  advance(w);
  const bool jump = wantsJump(w, onGround);
  if (here().marks & kGuideRepeat) {
    held_ = here().action;
    sim::Action repeated = held_;
    held_.jump = false;
    return repeated;
  }
  steer(w, onGround, params);
  sim::Action action = held_;
  action.jump = jump;
  return action;
}

}  // namespace obby::solve
