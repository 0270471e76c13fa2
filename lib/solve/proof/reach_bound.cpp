#include "solve/proof/reach_bound.h"

#include <algorithm>
#include <utility>

#include "solve/proof/body_reach.h"
#include "solve/proof/rounding.h"

namespace obby::solve {

namespace {

// Studs/s: what is slower pushes nobody anywhere within a flight.
constexpr float kPushes = 0.05f;

// As seen from above.
Box flat(const Box& box, float more) {
  return {{box.lo.x - more, 0, box.lo.z - more}, {box.hi.x + more, 0, box.hi.z + more}};
}

std::vector<Box> flatFeet(const std::vector<Support>& supports) {
  std::vector<Box> boxes;
  boxes.reserve(supports.size());
  for (const Support& s : supports) boxes.push_back(flat(s.feet, 0));
  return boxes;
}

}  // namespace

ReachBound::ReachBound(const Problem& problem, bool mayJump)
    : problem_(problem),
      p_(problem.level.params),
      mayJump_(mayJump),
      jumpSpeed_(fastestJump(problem.level)),
      walkSpeed_(fastestWalk(problem.level) + keyOvershoot(p_) + roundedInFlight(problem)),
      supports_(supportsOf(problem)),
      index_(flatFeet(supports_)),
      flight_(p_, walkSpeed_) {
  for (const Support& s : supports_) {
    lowest_ = std::min(lowest_, s.entry);
    slopes_ |= s.tilted;
    const bool pushes = s.pushes > kPushes || s.bursts;
    if (s.carries && pushes) pushers_.push_back({s.pushed, s.pushes, s.bursts});
  }
  pushers_ = fewPushers(std::move(pushers_));
  // What is reached makes faster, and who is faster reaches more.
  for (;;) {
    explore();
    const float fastest = fastestReached();
    if (!(fastest > flight_.sideways())) return;
    flight_ = Flight(p_, fastest);
  }
}

Launch ReachBound::launch(const Support& s, bool jumping) const {
  const float jump = jumping ? jumpSpeed_ : 0.0f, lifted = s.upward + jump, ramp = rampSpeed(s);
  Box from = s.feet;
  if (jumping) from.hi.y += ramp * (p_.coyoteTime + 2 * p_.tickSeconds);
  // The first tick of a jump is not held to the fastest that anybody moves.
  if (lifted > p_.maxFallSpeed) from.hi.y += lifted * p_.tickSeconds;
  // From the top of such a throw somebody may still jump.
  const float sprung = s.sprung > 0 ? sqrtf32(s.sprung * s.sprung + jump * jump) : 0.0f;
  // Nor is one that stands for what floors and legs lead to before.
  const float thrown = std::max(s.thrown, sprung), most = p_.maxFallSpeed;
  if (thrown > most) from.hi.y += (thrown * thrown - most * most) / (2 * p_.gravity);
  return {from, std::min(std::max({lifted, thrown, ramp}), most)};
}

// Who is pushed is moved along with what pushes, and keeps the height and speed of the flight: only
// the ways to it, on from it and between two of them are flown.
std::vector<Ride> ReachBound::ridesFrom(const Support& s, float lowest) const {
  if (pushers_.empty()) return {};
  return ridesOn(launch(s), std::min(lowest, s.feet.hi.y));
}

std::vector<Ride> ReachBound::ridesOn(const Launch& l, float lowest) const {
  std::vector<Ride> open;
  if (pushers_.empty()) return open;
  const float farthest = flight_.reach(l, lowest);
  for (const Pusher& by : pushers_) {
    const bool meets = by.pushed.lo.y - p_.bodyTop <= flight_.apex(l);
    if (meets && by.speed > kPushes) open.push_back({&by, gapBetween(l.from, by.pushed)});
  }
  return nearestFirst(std::move(open), farthest);
}

bool ReachBound::crosses(const Launch& l, float gap, const Support& to, bool jumping) const {
  float height = to.entry;
  // The torso does not collide as a jump begins: it can be inside of what is beside it then, and be
  // lifted out of that.
  if (jumping && to.carries && to.collider != level::kNone) {
    const float early = l.from.hi.y + 3 * l.upward * p_.tickSeconds + p_.headBottom;
    if (to.top <= early) height = std::min(height, l.from.hi.y);
  }
  return flight_.reach(l, height) >= gap;
}

// Breadth first by the number of jumps.
void ReachBound::explore() {
  jumps_.assign(supports_.size(), kNever);
  jumps_[0] = 0;
  std::vector<uint32_t> now{0}, later;
  for (uint32_t made = 0; !now.empty(); ++made) {
    for (size_t i = 0; i < now.size(); ++i) {
      // Else it was reached with fewer jumps after it was noted down.
      if (jumps_[now[i]] == made) spread(now[i], now, later);
    }
    now.swap(later);
    later.clear();
  }
}

void ReachBound::spread(uint32_t from, std::vector<uint32_t>& now, std::vector<uint32_t>& later) {
  const Support& s = supports_[from];
  const uint32_t made = jumps_[from];
  const auto arrive = [&](uint32_t to, uint32_t jumps) {
    if (jumps >= jumps_[to]) return;
    jumps_[to] = jumps;
    (jumps == made ? now : later).push_back(to);
  };
  if (s.leadsTo != level::kNone) arrive(s.leadsTo, made);
  const Launch falling = launch(s, false), leaping = launch(s, true);
  const bool leaps = mayJump_ && s.carries;
  // Nobody comes farther than down to the lowest of all: most supports need no closer look.
  const float lowest = std::min(lowest_, s.feet.hi.y);
  const float farthest = flight_.reach(leaps ? leaping : falling, lowest);
  const std::vector<Ride> rides = ridesFrom(s, lowest);
  forNear(s.feet, rides, farthest, [&](uint32_t to) {
    if (supports_[to].collider == level::kNone || jumps_[to] <= made) return;
    // Too high, whatever takes along: ways over hundreds of rides are not looked at for nothing.
    const bool falls = rides.empty() || crosses(falling, 0, supports_[to], false);
    if (!falls && !(leaps && crosses(leaping, 0, supports_[to], true))) return;
    const float gap = wayBetween(s.feet, rides, supports_[to].feet);
    if (gap > farthest) return;
    if (crosses(falling, gap, supports_[to], false)) {
      arrive(to, made);
    } else if (leaps && crosses(leaping, gap, supports_[to], true)) {
      arrive(to, made + 1);
    }
  });
}

// All supports that are no farther than that, and some others; some more than once.
template <class Near>
void ReachBound::forNear(const Box& feet, const std::vector<Ride>& rides, float farthest,
                         Near&& near) const {
  constexpr size_t kFew = 64, kMostRides = 16;  // from then on all are looked at sooner
  if (supports_.size() <= kFew || rides.size() > kMostRides) {
    for (uint32_t to = 0; to < supports_.size(); ++to) near(to);
    return;
  }
  index_.find(flat(feet, farthest + kSlack), near);
  for (const Ride& ride : rides) {
    index_.find(flat(ride.by->pushed, farthest - ride.way + kSlack), near);
  }
}

Box ReachBound::boxOf(const level::TargetView& target) const {
  if (target.touchCount == 0) return boundsOf(target.region.pose, target.region.half);
  const level::LevelView& level = problem_.level;
  Box all = level.bounds[problem_.query.touched[target.firstTouch]].box();
  for (uint32_t i = 1; i < target.touchCount; ++i) {
    all = join(all, level.bounds[problem_.query.touched[target.firstTouch + i]].box());
  }
  const float limbs = 0.5f * (std::max(p_.armSpan, p_.bodyWidth) + p_.bodyDepth) + p_.touchMargin;
  // Of short limbs that touch from afar the corners are farther out.
  const float side = std::max(limbs, limbSide(p_) + 1.5f * p_.touchMargin);
  return grow(all, {side, p_.touchMargin, side});
}

uint32_t ReachBound::jumpsTo(const level::TargetView& target) const {
  const Box box = boxOf(target);
  const float height = box.lo.y - p_.bodyTop;
  uint32_t fewest = kNever;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] >= fewest) continue;
    const Support& s = supports_[i];
    const bool leaps = mayJump_ && s.carries && jumps_[i] + 1 < fewest;
    const float falling = flight_.reach(launch(s, false), height);
    const float leaping = leaps ? flight_.reach(launch(s, true), height) : -1.0f;
    if (falling < 0 && leaping < 0) continue;  // too high, whatever takes along
    const float gap = wayBetween(s.feet, ridesFrom(s, height), box);
    if (falling >= gap) {
      fewest = jumps_[i];
    } else if (leaping >= gap) {
      fewest = jumps_[i] + 1;
    }
  }
  return fewest;
}

bool ReachBound::holds(Vec3 feet) const {
  const Box point{feet, feet};
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    const Support& s = supports_[i];
    const float reach = flight_.reach(launch(s), feet.y);
    if (reach >= gapBetween(s.feet, point)) return true;
    if (reach >= wayBetween(s.feet, ridesFrom(s, feet.y), point)) return true;
  }
  return false;
}

bool ReachBound::comesInto(const std::vector<Box>& places) const {
  if (places.empty()) return false;
  float lowest = lowest_;
  for (const Box& place : places) lowest = std::min(lowest, place.lo.y);
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    const Support& s = supports_[i];
    const Launch l = launch(s);
    const std::vector<Ride> rides = ridesFrom(s, lowest);
    for (const Box& place : places) {
      const float reach = flight_.reach(l, place.lo.y);
      if (reach >= 0 && reach >= wayBetween(s.feet, rides, place)) return true;
    }
  }
  return false;
}

Missing ReachBound::missing(const std::vector<const level::TargetView*>& targets) const {
  std::vector<Box> boxes;
  float lowest = lowest_;
  for (const level::TargetView* t : targets) {
    boxes.push_back(boxOf(*t));
    lowest = std::min(lowest, boxes.back().lo.y - p_.bodyTop);
  }
  Missing best;
  float least = 1e30f;
  const auto consider = [&](const Support& s, const Launch& l, const std::vector<Ride>& rides,
                            const Box& box, float height, uint32_t collider) {
    const float rise = std::max(height - flight_.apex(l), 0.0f);
    if (!(rise < least)) return;  // whatever takes along
    const float reach = flight_.reach(l, std::min(height, flight_.apex(l)));
    const float gap = std::max(wayBetween(s.feet, rides, box) - reach, 0.0f);
    if (!(rise + gap < least)) return;
    least = rise + gap;
    best = {s.collider, collider, rise, gap};
  };
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    const Support& from = supports_[i];
    const Launch l = launch(from);
    const std::vector<Ride> rides = ridesFrom(from, lowest);
    for (const Box& box : boxes) {
      consider(from, l, rides, box, box.lo.y - p_.bodyTop, level::kNone);
    }
    for (size_t j = 0; j < supports_.size(); ++j) {
      const Support& to = supports_[j];
      if (jumps_[j] == kNever && to.collider != level::kNone) {
        consider(from, l, rides, to.feet, to.entry, to.collider);
      }
    }
  }
  return best;
}

float ReachBound::fastest() const {
  float pushed = 0;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    if (supports_[i].snaps) return std::numeric_limits<float>::infinity();
    pushed = std::max(pushed, supports_[i].pushes);
    // Nobody lives to be pushed below where everything falls out of the world.
    const float lowest = std::min(lowest_, p_.fallenPartsHeight);
    for (const Ride& r : ridesFrom(supports_[i], lowest)) pushed = std::max(pushed, r.by->speed);
  }
  // Slopes overhead may give it again before keys have taken it back.
  const float most = std::max(fastestOfAll(), flight_.sideways());
  const bool glances = most > flight_.sideways() && glancesOver(false);
  return (glances ? most : flight_.sideways()) + pushed;
}

std::vector<uint32_t> ReachBound::reached() const {
  std::vector<uint32_t> colliders;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] != kNever && supports_[i].carries) colliders.push_back(supports_[i].collider);
  }
  return colliders;
}

}  // namespace obby::solve
