// Falls onto slopes: what the legs do not feel, between their rays, turns speed downward aside.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "solve/proof/body_reach.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {

namespace {

constexpr float kNoFall = -1e30f;       // studs
constexpr size_t kMostPairs = 400'000;  // of what is fallen from and onto; from then on any
constexpr int kPasses = 8;              // of falls from one slope onto the next; likewise
constexpr int kHeights = 16;            // of a slope, looked at one by one
constexpr int kRuns = 8;                // from where somebody lands to where they jump, likewise

// Seconds from the beginning of a jump until the legs have lost the floor.
float secondsToLeave(const Params& p, float jump) {
  const float left = jump * jump - 2 * p.gravity * floorReach(p);
  const float rises = left > 0 ? jump - sqrtf32(left) : jump;
  return p.tickSeconds + rises / p.gravity;
}

// How far ahead of somebody at some speed is who is so much faster, after `seconds` or sooner, and
// is slowed down to `less` than that speed.
float aheadBy(float gained, float less, float brake, float seconds) {
  if (!(seconds > gained / brake)) return gained * gained / (2 * brake);
  const float slow = std::min(seconds, (gained + less) / brake);
  return slow * (gained - 0.5f * brake * slow) - less * (seconds - slow);
}

}  // namespace

// From where somebody falls who leaves that support, or has fallen from `reached` onto it.
ReachBound::Fall ReachBound::fallFrom(const Support& s, float reached) const {
  Launch l = launch(s);
  const float down = s.keepsSpeed ? p_.maxFallSpeed : s.down;
  const float thrown = s.feet.hi.y + down * down / (2 * p_.gravity);
  const float top = std::max({flight_.apex(l), reached, thrown});
  const float more = std::max(2 * p_.gravity * (top - l.from.hi.y), 0.0f);
  l.upward = std::max(l.upward, sqrtf32(more));
  return {l, top};
}

// (supports): from where feet fall onto slopes that are reached, at the highest; kNoFall: nobody
// does.
std::vector<float> ReachBound::highestFalls() const {
  std::vector<float> highest(supports_.size(), kNoFall);
  std::vector<size_t> from, slopes;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    from.push_back(i);
    if (supports_[i].tilted) slopes.push_back(i);
  }
  if (slopes.empty()) return highest;
  const auto topOf = [&](size_t i) { return fallFrom(supports_[i], kNoFall).top; };
  std::sort(from.begin(), from.end(), [&](size_t a, size_t b) { return topOf(a) > topOf(b); });
  if (from.size() * slopes.size() <= kMostPairs && spreadFalls(from, slopes, highest)) {
    return highest;
  }
  for (const size_t i : slopes) highest[i] = topOf(from.front());
  return highest;
}

// Who glances off one slope falls on, onto the next. False: not all is known after many of them.
bool ReachBound::spreadFalls(const std::vector<size_t>& from, const std::vector<size_t>& slopes,
                             std::vector<float>& highest) const {
  for (int pass = 0; pass < kPasses; ++pass) {
    bool grows = false;
    for (const size_t i : from) {
      const Fall fall = fallFrom(supports_[i], highest[i]);
      const auto isNews = [&](size_t to) { return highest[to] < fall.top; };
      if (std::none_of(slopes.begin(), slopes.end(), isNews)) continue;
      const float lowest = std::min(lowest_, supports_[i].feet.hi.y);
      const std::vector<Ride> rides = ridesOn(fall.from, lowest);
      for (const size_t to : slopes) {
        const Support& s = supports_[to];
        if (!isNews(to)) continue;
        const float reach = flight_.reach(fall.from, s.entry);
        if (reach < 0 || reach < wayBetween(fall.from.from, rides, s.feet)) continue;
        highest[to] = fall.top;
        grows = true;
      }
    }
    if (!grows) return true;
  }
  return false;
}

// Is another slope so near, seen from above, that somebody comes to it before keys have slowed them
// down? Then the two may turn more of a fall aside than one. Among very many it is so.
bool ReachBound::isSlopeNear(size_t support, float studs) const {
  constexpr size_t kMany = 4000;
  if (supports_.size() > kMany) return true;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (i == support || !supports_[i].tilted) continue;
    if (gapBetween(supports_[i].feet, supports_[support].feet) <= studs) return true;
  }
  return false;
}

// Fastest sideways after falling onto slopes, studs/s. No contact makes anybody faster than they
// are; one turns half of the fall aside. Fallen from one to the next, keys slow down meanwhile.
float ReachBound::speedAfter(float before, float fall, bool together) const {
  if (!together) return 0.5f * (before + length(Vec3{before, fall, 0}));
  const float braked = std::clamp(p_.airAccel / p_.gravity, 0.1f, 1.0f);
  const float kept = fall * (1 - braked * braked) / (2 * braked);
  return length(Vec3{std::max(before, kept), fall, 0});
}

// What a glance at so many studs/s is, that nobody has for more than a tick if it is too fast.
// `below`: of Glance.
ReachBound::Glance ReachBound::glanceAt(float speed, float below) const {
  const float after = std::min(speed, fastestOfAll());
  return {after, (speed - after) * p_.tickSeconds, below};
}

// Does somebody come farther by it than at `more` beside walking all the time? They fall on, or
// land and jump.
bool ReachBound::outruns(const Glance& g, float more) const {
  const float usual = walkSpeed_ + more, brake = p_.airAccel;
  const float gained = std::max(g.after - usual, 0.0f), late = p_.coyoteTime + 2 * p_.tickSeconds;
  if (g.atOnce + gained * gained / (2 * brake) > kFeetSpare + usual * late) return true;
  if (!mayJump_) return false;
  // Keys do nothing as a jump begins. It is no shorter than up to its top.
  const float leaves = secondsToLeave(p_, jumpSpeed_), rises = jumpSpeed_ / p_.gravity;
  const auto jumpsAhead = [&](float faster, float seconds) {
    return aheadBy(faster, more, brake, seconds + rises) + leaves * faster;
  };
  const float landed = float(landedTicksOf(p_)) * p_.tickSeconds;
  if (g.below < 0) return jumpsAhead(gained, 0) > kFeetSpare;
  // The same flight from so far above lasts longer by at least that.
  const float longer = sqrtf32(2 * g.below / p_.gravity * more * (2 * walkSpeed_ + more));
  const float most = kFeetSpare + longer - g.atOnce;
  // Landed at an edge they are in the air again at once.
  const float edge = jumpsAhead(gained, landed);
  if (edge > kFeetSpare && edge + usual * landed > most) return true;
  const float least = std::max(gained - (p_.traction * p_.plainGrip) * landed, 0.0f);
  for (int k = 0; k < kRuns; ++k) {
    const float faster = least * (1 - float(k) / kRuns), ahead = jumpsAhead(faster, 0);
    if (ahead <= kFeetSpare) return false;
    const float run = (gained - faster) / (p_.traction * p_.plainGrip);  // seconds
    if (ahead + run * (usual + 0.5f * (gained + faster)) > most) return true;
  }
  return false;
}

// Studs/s beside walking that are enough for falls onto slopes too; `given`: that somebody may have
// before, `more`: granted anyway.
float ReachBound::turnedAside(float given, float more) const {
  bool ice = false;
  for (size_t i = 0; i < supports_.size(); ++i) {
    ice = ice || (jumps_[i] != kNever && isIce(supports_[i]));
  }
  const std::vector<float> highest = highestFalls();
  const float usual = walkSpeed_ + given;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (!(highest[i] > kNoFall)) continue;
    const Support& s = supports_[i];
    const float fastest = std::min(speedAfter(usual, p_.maxFallSpeed, false), fastestOfAll());
    const bool together = isSlopeNear(i, fastest * fastest / (2 * p_.airAccel));
    const float span = std::max(s.top - p_.hipHeight - s.entry, 0.0f) / float(kHeights);
    for (int k = 0; k < kHeights; ++k) {
      const float low = s.entry + span * float(k), from = highest[i] - low;
      if (!(from > 0)) break;
      const float fall = std::min(sqrtf32(2 * p_.gravity * from), p_.maxFallSpeed);
      const float below = ice ? -1.0f : std::max(s.feet.hi.y - low - span, 0.0f);
      const Glance glance = glanceAt(speedAfter(usual, fall, together), below);
      while (outruns(glance, more)) more = std::max(1.125f * more, kSteepSpeed);
    }
  }
  return more;
}

}  // namespace obby::solve
