// What the bound on reach says of places and queries.
#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "solve/proof/reach_bound.h"

namespace obby::solve {

Box ReachBound::boxOf(const level::TargetView& target) const {
  if (target.touchCount == 0) return boundsOf(target.region.pose, target.region.half);
  const level::LevelView& level = problem_.level;
  Box all = level.bounds[problem_.query.touched[target.firstTouch]].box();
  for (uint32_t i = 1; i < target.touchCount; ++i) {
    all = join(all, level.bounds[problem_.query.touched[target.firstTouch + i]].box());
  }
  return grow(all, {limits_.limb, 1.5f * p_.touchMargin, limits_.limb});
}

// The axis of a body is not inside of a part that the body is pushed out of: in a region over that
// part the torso is above its top.
void ReachBound::standOn(End& region) const {
  if (!limits_.staysOut) return;
  const Box& box = region.box;
  index_.find({{box.lo.x, 0, box.lo.z}, {box.hi.x, 0, box.hi.z}}, [&](uint32_t i) {
    const Support& s = supports_[i];
    if (!s.carries || s.wild || s.pushes > 0 || s.beside != Beside::clear) return;
    const Vec3 x = problem_.level.colliders[s.collider].pose.rotation.x;
    const bool axial = std::min(absf(x.x), absf(x.z)) < 1e-5f;
    const bool inside = box.lo.x >= s.box.lo.x && box.hi.x <= s.box.hi.x &&
                        box.lo.z >= s.box.lo.z && box.hi.z <= s.box.hi.z;
    if (!axial || !inside || box.lo.y <= s.box.lo.y + 2 * limits_.slack) return;
    const float height = s.top - p_.hipHeight - limits_.slack;
    if (!(height > region.falling)) return;
    region.falling = region.leaping = region.plain = height;
    region.support = i;
  });
}

ReachBound::End ReachBound::endAt(const level::TargetView& target) const {
  const Box box = boxOf(target);
  const float height = box.lo.y - p_.bodyTop;
  End end{box, height, height, height, 0, kNever};
  if (target.touchCount == 0) standOn(end);
  return end;
}

// Jumps on the way there, after those to the support.
uint32_t ReachBound::jumpsFrom(uint32_t support, const End& end) const {
  if (!isReached(support)) return kNever;
  if (crosses(support, fall(support), end)) return jumps_[support];
  const bool leap = leaps(supports_[support]) && crosses(support, this->leap(support), end);
  return leap ? jumps_[support] + jumpsOfLeap() : kNever;
}

// What may hold a player whose feet are in the region.
std::vector<uint32_t> ReachBound::holdersIn(const level::TargetView& target) const {
  std::vector<uint32_t> holders;
  const Box box = boxOf(target);
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    const Support& s = supports_[i];
    const float low = s.climbed ? p_.bodyTop : limits_.sunk();
    const Box feet{s.box.lo - Vec3{s.side, low, s.side},
                   s.box.hi + Vec3{s.side, s.lift + limits_.mostTakeOff(), s.side}};
    if (s.collider != level::kNone && overlaps(feet, box)) holders.push_back(i);
  }
  return holders;
}

uint32_t ReachBound::jumpsTo(const level::TargetView& target) const {
  if (wild_) return 0;
  uint32_t fewest = kNever;
  if (target.stand) {
    for (const uint32_t i : holdersIn(target)) fewest = std::min(fewest, jumps_[i]);
    return fewest;
  }
  const End end = endAt(target);
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] < fewest) fewest = std::min(fewest, jumpsFrom(i, end));
  }
  return fewest;
}

bool ReachBound::holds(Vec3 feet) const { return comesInto({{feet, feet}}); }

bool ReachBound::comesInto(const std::vector<Box>& places) const {
  if (wild_) return !places.empty();
  for (const Box& place : places) {
    const End end{place, place.lo.y, place.lo.y, place.lo.y, 0, kNever};
    for (uint32_t i = 0; i < supports_.size(); ++i) {
      if (jumpsFrom(i, end) != kNever) return true;
    }
  }
  return false;
}

// What a plain jump lacks, or a plain fall: from the rays' radius to the rays' radius, at the speed
// of a walk, without what only the best of timing gives.
Missing ReachBound::lack(uint32_t from, const End& to) const {
  const Support& s = supports_[from];
  const bool leap = leaps(s);
  const Flight f{s.top, leap ? std::max(limits_.jump, s.toss) : s.toss, leap, limits_.ray};
  const bool lands = to.support != kNever && supports_[to.support].carries;
  const float height = lands ? to.plain : to.leaping, high = apex(f);
  const float studs = limits_.walk * std::max(secondsOf(f, std::min(height, high)), 0.0f);
  const float radii =
      s.side - (s.carries ? limits_.ray : s.side) + (lands ? to.side - limits_.ray : 0);
  const float gap = wayTo(from, to) + radii - studs;
  Missing step{s.collider, level::kNone, std::max(height - high, 0.0f), std::max(gap, 0.0f)};
  if (to.support < supports_.size()) step.to = supports_[to.support].collider;
  return step;
}

// Dijkstra's search through all supports for the route that lacks least.
Missing ReachBound::missing(const std::vector<const level::TargetView*>& targets) const {
  std::vector<End> ends;
  for (uint32_t i = 0; i < supports_.size(); ++i) ends.push_back(endAt(i));
  for (const level::TargetView* t : targets) {
    if (!t->stand) ends.push_back(endAt(*t));
    for (const uint32_t i : t->stand ? holdersIn(*t) : std::vector<uint32_t>())
      ends.push_back(endAt(i));
  }
  struct Route {
    float lacks = 1e30f;
    Missing first = {};  // step that lacks anything
  };
  std::vector<Route> routes(ends.size());
  std::priority_queue<std::pair<float, uint32_t>, std::vector<std::pair<float, uint32_t>>,
                      std::greater<>>
      open;
  const auto come = [&](uint32_t to, const Route& by) {
    routes[to] = by;
    open.emplace(by.lacks, to);
  };
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if (isReached(i)) come(i, {0, {}});
  }
  while (!open.empty()) {
    const float lacks = open.top().first;
    const uint32_t at = open.top().second;
    open.pop();
    const Route route = routes[at];
    if (lacks > route.lacks) continue;
    if (at >= supports_.size() || supports_[at].wild) return route.first;
    const uint32_t leadsTo = supports_[at].leadsTo;
    if (leadsTo != level::kNone && lacks < routes[leadsTo].lacks) come(leadsTo, route);
    for (uint32_t to = 0; to < ends.size(); ++to) {
      if (to < supports_.size() && supports_[to].collider == level::kNone) continue;
      if (routes[to].lacks <= lacks) continue;  // no step lacks less than nothing
      const Missing step = lack(at, ends[to]);
      const float all = lacks + step.rise + step.gap;
      if (!(all < routes[to].lacks)) continue;
      Route next{all, lacks > 0 ? route.first : step};
      if (lacks > 0) {
        next.first.more |= all > lacks;
      } else {
        const float between = gapBetween(supports_[at].box, ends[to].box) - 2 * limits_.body;
        if (to >= supports_.size()) next.first.to = level::kNone;
        next.first.blocked = partsNear(at, leap(at), ends[to], between) > 0;
      }
      come(to, next);
    }
  }
  return {};
}

std::vector<uint32_t> ReachBound::reached() const {
  std::vector<uint32_t> colliders;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if ((wild_ || isReached(i)) && supports_[i].carries) colliders.push_back(supports_[i].collider);
  }
  return colliders;
}

float ReachBound::secondsFor(float studs) const {
  const bool hops = (p_.tricks & kWallHop) != 0;
  if (wild_ || excess_ > 0 || !limits_.staysOut || hops) return 0;
  float pushes = 0;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    const Support& s = supports_[i];
    if (s.beside != Beside::clear || s.pushes > 0 || s.leadsTo != level::kNone) return 0;
    if (s.carries) pushes += 2 * limits_.turned;
  }
  return std::max(studs - pushes, 0.0f) / limits_.walk;
}

}  // namespace obby::solve
