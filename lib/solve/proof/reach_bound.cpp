#include "solve/proof/reach_bound.h"

#include <algorithm>
#include <utility>

#include "sim/floor.h"

namespace obby::solve {

namespace {

constexpr int kMostRounds = 60;
constexpr int kMostParts = 8;  // near a flight, that lift it; more push it as far as turns can

// As seen from above.
Box flat(const Box& box, float more) {
  return {{box.lo.x - more, 0, box.lo.z - more}, {box.hi.x + more, 0, box.hi.z + more}};
}

std::vector<Box> flatBoxes(const std::vector<Support>& supports) {
  std::vector<Box> boxes;
  boxes.reserve(supports.size());
  for (const Support& s : supports) boxes.push_back(flat(s.box, s.side));
  return boxes;
}

}  // namespace

ReachBound::ReachBound(const Problem& problem, bool mayJump)
    : problem_(problem),
      p_(problem.level.params),
      motions_(motionsOf(problem)),
      limits_(problem, motions_),
      mayJump_(mayJump),
      supports_(supportsOf(problem, limits_, motions_)),
      index_(flatBoxes(supports_)) {
  for (const Support& s : supports_) {
    lowest_ = std::min(lowest_, s.entryFalling);
    if (s.beside != Beside::deep) pushed_ = std::max(pushed_, s.pushes);
    takeOff_.push_back(!s.carries ? 0 : s.level ? s.held : limits_.mostTakeOff());
  }
  explore();
}

bool ReachBound::raise(float& value, float to) {
  if (!raises(value, to)) return false;
  value = to;
  return changed_ = true;
}

// What is reached lets players take off higher and faster, and they reach more then.
void ReachBound::explore() {
  for (int i = 0; i < kMostRounds; ++i) {
    changed_ = false;
    round();
    if (!changed_ || wild_) return;
  }
  wild_ = true;
}

// Breadth first by the number of jumps.
bool ReachBound::round() {
  jumps_.assign(supports_.size(), kNever);
  jumps_[0] = 0;
  std::vector<uint32_t> now{0}, later;
  for (uint32_t made = 0; !now.empty(); ++made) {
    for (size_t i = 0; i < now.size(); ++i) {
      if (jumps_[now[i]] == made) spread(now[i], now, later);
    }
    now.swap(later);
    later.clear();
  }
  return changed_;
}

void ReachBound::noteReached(uint32_t support) {
  const Support& s = supports_[support];
  wild_ |= s.wild;
  raise(excess_, s.sideways);
  raise(tossed_, std::max(s.toss, leaps(s) ? limits_.jump + s.upward : 0.0f));
  if (s.carries && limits_.thrown > 0) raise(tossed_, limits_.thrownBy(s.vertical) + s.upward);
}

float ReachBound::tossOf(uint32_t support) const {
  const Support& s = supports_[support];
  float up = s.toss;
  if (s.carries && limits_.thrown > 0) up = std::max(up, limits_.thrownBy(s.vertical) + s.upward);
  // Who flicks comes off the truss as fast as a jump.
  if (mayJump_ && s.climbed && (p_.tricks & kLadderFlick))
    up = std::max(up, limits_.jump + s.upward);
  // A body in a part may be put out of it as fast as it came there.
  if (s.beside == Beside::deep) up = std::max(up, tossed_);
  if (s.beside == Beside::pinched && mayJump_) up = std::max(up, limits_.jump);
  return up;
}

ReachBound::Flight ReachBound::fall(uint32_t support) const {
  const Support& s = supports_[support];
  float height = s.top + s.lift + takeOff_[support], up = tossOf(support);
  // A held jump may go on beside a part that takes the body along.
  if (s.beside == Beside::deep) height = s.top + s.lift + limits_.letGo(takeOff_[support], up);
  if (limits_.thrown > 0) height += up * p_.tickSeconds;
  // The first tick of a launch is not held to the fastest speed.
  if (up > p_.maxFallSpeed) height += up * p_.tickSeconds;
  return {height, std::min(up, p_.maxFallSpeed), false, s.side};
}

ReachBound::Flight ReachBound::leap(uint32_t support) const {
  const Support& s = supports_[support];
  const float up = limits_.jump + s.upward;
  const float takeOff = takeOff_[support] + limits_.fallApex(s.rising);
  float height = s.top + s.lift + limits_.letGo(takeOff, up);
  if (up > p_.maxFallSpeed) height += up * p_.tickSeconds;
  return {height, std::min(up, p_.maxFallSpeed), true, s.stand};
}

float ReachBound::apex(const Flight& f) const {
  return f.height + (f.leaps ? limits_.leapApex(f.up) : limits_.fallApex(f.up));
}

float ReachBound::secondsOf(const Flight& f, float height) const {
  const float rise = height - f.height;
  const float seconds = f.leaps ? limits_.leapSeconds(f.up, rise) : limits_.fallSeconds(f.up, rise);
  return seconds < 0 ? seconds : seconds + limits_.heldSeconds;
}

// Studs sideways from the support's box, until the feet are as low as `height`.
float ReachBound::reach(const Flight& f, float height) const {
  const float rise = height - f.height;
  const float studs = limits_.sideways(secondsOf(f, height), excess_);
  if (studs < 0) return -1;
  // Below the hips the support's own side may push.
  const bool below = rise < -0.5f * p_.hipHeight;
  return below ? std::max(studs, limits_.body - f.radius) : studs;
}

// The torso does not collide as a jump begins: it may be inside of a part that the head clears.
bool ReachBound::stepsInto(const Flight& f, const Support& to, float way) const {
  if (!f.leaps || !to.carries) return false;
  const float ticks = f.up * (p_.tickSeconds + p_.substepSeconds);
  const float late =
      limits_.sideways(p_.coyoteTime + 3 * p_.tickSeconds + limits_.heldSeconds, excess_);
  return to.lowest <= f.height + ticks + p_.headBottom + limits_.slack && way <= late;
}

bool ReachBound::crosses(uint32_t from, const Flight& f, const End& to) const {
  const float height = f.leaps ? to.leaping : to.falling;
  const float own = wayTo(from, to) + (supports_[from].side - f.radius);
  const float studs = reach(f, height);
  if (studs >= 0 && studs >= own) return true;
  // Parts on the way lift a body that turns beside them, or push it on: as many as are near enough
  // for what they give.
  const float each = 2 * limits_.turned;
  for (int parts = kMostParts;;) {
    const float low = height - float(parts) * limits_.turned, lifted = reach(f, low);
    if (lifted < 0) return false;
    const float seconds = secondsOf(f, low);
    const float turns = limits_.turning * seconds + each;
    const float all = lifted + pushed_ * seconds +
                      (parts == kMostParts ? turns : std::min(float(parts) * each, turns));
    if (all < own) return false;
    const int near = partsNear(from, f, to, all);
    if (near >= parts) return true;
    if (near == 0) return false;
    parts = near;
  }
}

// Solid parts that a flight of that length may meet: kMostParts where there are more.
int ReachBound::partsNear(uint32_t from, const Flight& f, const End& to, float studs) const {
  const Support& s = supports_[from];
  const float low = std::min(to.falling, to.leaping), high = apex(f) + p_.bodyTop;
  const float far = studs + f.radius + to.side + 2 * limits_.body;
  int count = 0;
  index_.findWhile(flat(join(s.box, to.box), far), [&](uint32_t i) {
    const Support& by = supports_[i];
    const bool meets = i != from && i != to.support && by.carries && by.box.hi.y >= low &&
                       by.box.lo.y <= high &&
                       gapBetween(s.box, by.box) + gapBetween(by.box, to.box) <= far;
    count += meets ? 1 : 0;
    return count < kMostParts;
  });
  return count;
}

// Studs of own way, beyond the radii of both ends.
float ReachBound::wayTo(uint32_t from, const End& to) const {
  const Support& s = supports_[from];
  return gapBetween(s.box, to.box) - s.side - to.side;
}

ReachBound::End ReachBound::endAt(uint32_t support) const {
  const Support& s = supports_[support];
  const float plain = s.level ? s.lowest - sim::rayHeight(p_) : s.entry;
  return {s.box, s.entryFalling, s.entry, plain, s.side, support};
}

void ReachBound::spread(uint32_t from, std::vector<uint32_t>& now, std::vector<uint32_t>& later) {
  const Support& s = supports_[from];
  const uint32_t made = jumps_[from];
  noteReached(from);
  const auto come = [&](uint32_t to, uint32_t jumps) {
    if (jumps >= jumps_[to]) return;
    jumps_[to] = jumps;
    (jumps == made ? now : later).push_back(to);
  };
  if (s.leadsTo != level::kNone) come(s.leadsTo, made);
  const Flight falling = fall(from), leaping = leap(from);
  const bool jumps = leaps(s);
  const float low = lowest_ - kMostParts * limits_.turned;
  const float seconds = std::max({secondsOf(falling, low), secondsOf(leaping, low), 0.0f});
  const float most = limits_.sideways(seconds, excess_) + 2 * limits_.turned + limits_.across +
                     (limits_.turning + pushed_) * seconds;
  index_.find(flat(s.box, most + s.side), [&](uint32_t to) {
    if (supports_[to].collider == level::kNone) return;
    const End end = endAt(to);
    const auto fly = [&](const Flight& f, uint32_t after) {
      if (after >= jumps_[to] && !raises(takeOff_[to], limits_.landedTakeOff)) return;
      const float takeOff = takeOffAfter(from, to, f);
      if (after >= jumps_[to] && !raises(takeOff_[to], takeOff)) return;  // nothing new
      const bool enters = f.leaps && stepsInto(f, supports_[to], wayTo(from, end));
      if (!enters && !crosses(from, f, end)) return;
      if (raises(takeOff_[to], takeOff) && comesOver(from, to, f)) raise(takeOff_[to], takeOff);
      come(to, after);
    };
    fly(falling, made);
    if (jumps) fly(leaping, made + jumpsOfLeap());
  });
}

// Does the flight come to the top of a support, and not below it only?
bool ReachBound::comesOver(uint32_t from, uint32_t to, const Flight& f) const {
  const Support& b = supports_[to];
  End top = endAt(to);
  top.falling = top.leaping = std::min(b.top + b.lift, apex(f)) - limits_.fallApex(b.upward);
  return crosses(from, f, top);
}

// How high above its own top a support may be left after that flight; below 0: it says nothing.
float ReachBound::takeOffAfter(uint32_t from, uint32_t to, const Flight& f) const {
  const Support &a = supports_[from], &b = supports_[to];
  if (!b.carries || !b.level) return -1;
  const float floor = b.top + b.lift, high = apex(f) - floor;
  if (high <= takeOff_[to]) return -1;
  // The flight may also begin lower and be slower.
  float low = a.top, slow = limits_.slowJump;
  if (a.collider != level::kNone) {
    low = (from == to ? a.top : a.lowest) - limits_.sunk();
    if (from == to) {  // the floor goes up meanwhile
      low -= a.vertical * (p_.coyoteTime + p_.tickSeconds);
      slow = std::max(slow - 3 * a.vertical, 0.0f);
    }
  }
  if (f.leaps) low += limits_.leapApex(slow);
  const float landed = limits_.takeOff({low - floor, high}, b.upward);
  return f.leaps ? landed : std::max(landed, limits_.keptTakeOff(high));
}

}  // namespace obby::solve
