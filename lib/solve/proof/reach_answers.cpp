// Evaluates the bound on reach for places and queries.
#include <algorithm>

#include "sim/floor.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {

Box ReachBound::boxOf(const level::TargetView& target) const {
  if (target.touchCount == 0) return boundsOf(target.region.pose, target.region.half);
  Box all = noBox();
  for (uint32_t i = 0; i < target.touchCount; ++i) {
    const uint32_t collider = problem_.query.touched[target.firstTouch + i];
    all = join(all, problem_.level.bounds[collider].box());
  }
  return grow(all, {limits_.limb, 1.5f * p_.touchMargin, limits_.limb});
}

// Returns the places that cover a target: a player at the target is in at least one of them.
std::vector<ReachBound::End> ReachBound::endsOf(const level::TargetView& target) const {
  const Box box = boxOf(target);
  if (target.stand) return holdersIn(box);
  std::vector<End> ends{{box, box.lo.y - p_.bodyTop}};
  if (target.touchCount != 0) return ends;
  // A player over a clear block that covers the region has the torso above the block's top.
  index_.any(flat(box, 0), [&](uint32_t i) {
    const Support& s = supports_[i];
    const bool holds = s.carries && !s.wild && s.pushes == 0 && s.beside == Beside::clear &&
                       isAxial(problem_.level, s.collider);
    const bool over =
        isWithin(flat(box, 0), flat(s.box, 0)) && box.lo.y > s.box.lo.y + 2 * limits_.slack;
    if (holds && over && s.entry > ends[0].height) ends[0] = {box, s.entry, 0, i};
    return false;
  });
  return ends;
}

// Returns the supports that may hold a player whose feet are in the box.
std::vector<ReachBound::End> ReachBound::holdersIn(const Box& box) const {
  std::vector<End> ends;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    const Support& s = supports_[i];
    Box feet = grow(s.box, {s.side, 0, s.side});
    feet.lo.y = s.lowest - limits_.sunk;
    feet.hi.y += s.lift + limits_.maxTakeOff;
    if (s.collider != level::kNone && overlaps(feet, box)) ends.push_back(endAt(i));
  }
  return ends;
}

// Returns the min number of jumps on a route to the end; kNever if there is no route.
uint32_t ReachBound::jumpsInto(const End& end) const {
  if (wild_) return 0;
  uint32_t fewest = kNever;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    for (const bool leaps : {false, true}) {
      if (jumps_[i] >= fewest || (leaps && !mayLeap(supports_[i]))) continue;
      const Flight f = flight(i, leaps);
      if (crosses(i, f, end)) fewest = std::min(fewest, jumpsAfter(i, f));
    }
  }
  return fewest;
}

uint32_t ReachBound::jumpsTo(const level::TargetView& target) const {
  uint32_t fewest = kNever;
  for (const End& end : endsOf(target)) fewest = std::min(fewest, jumpsInto(end));
  return fewest;
}

bool ReachBound::holds(Vec3 feet) const { return jumpsInto({{feet, feet}, feet.y}) != kNever; }

// Returns the step with the distance by which a plain jump or fall at walking speed falls short.
// Distances are between the places where the rays sense a floor. The gains of perfect timing are
// ignored.
Missing ReachBound::lack(uint32_t from, const End& to) const {
  const Support& s = supports_[from];
  const bool leap = mayLeap(s);
  const Flight f{s.top(), std::max(s.toss, leap ? limits_.jump : 0), leap, 0};
  const bool lands = to.support != kNever && supports_[to.support].carries;
  const float height = lands ? supports_[to.support].lowest - sim::rayHeight(p_) : to.height;
  const float high = limits_.apex(f), rise = std::max(height - high, 0.0f);
  const float seconds = std::max(limits_.seconds(f, std::min(height, high)), 0.0f);
  const float radii = std::min(s.side, limits_.ray) + std::min(to.side, limits_.ray);
  const float gap = gapBetween(s.box, to.box) - radii - limits_.walk * seconds;
  return {s.collider, level::kNone, rise, std::max(gap, 0.0f)};
}

// Finds the route with the smallest missing distance, by Dijkstra's algorithm over all supports.
Missing ReachBound::missing(const std::vector<const level::TargetView*>& targets) const {
  std::vector<End> ends;
  for (uint32_t i = 0; i < supports_.size(); ++i) ends.push_back(endAt(i));
  for (const level::TargetView* t : targets) {
    for (const End& end : endsOf(*t)) ends.push_back(end);
  }
  struct Route {
    float lacks = 1e29f;
    bool done = false;
    Missing first = {};  // first step that lacks anything
  };
  std::vector<Route> routes(ends.size());
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if (isReached(i)) routes[i].lacks = 0;
  }
  for (;;) {
    uint32_t at = kNever;
    for (uint32_t i = 0; i < routes.size(); ++i) {
      if (!routes[i].done && (at == kNever || routes[i].lacks < routes[at].lacks)) at = i;
    }
    if (at == kNever) return {};
    Route& route = routes[at];
    if (at >= supports_.size() || supports_[at].wild) return route.first;
    route.done = true;
    const uint32_t gate = supports_[at].leadsTo;
    if (gate != level::kNone && route.lacks < routes[gate].lacks) {
      routes[gate] = {route.lacks, false, route.first};
    }
    for (uint32_t to = 0; to < ends.size(); ++to) {
      if (routes[to].lacks <= route.lacks) continue;  // no step lacks a negative amount
      Missing step = lack(at, ends[to]);
      const float all = route.lacks + step.rise + step.gap;
      if (!(all < routes[to].lacks)) continue;
      if (route.lacks > 0) {
        const bool more = all > route.lacks;
        step = route.first;
        step.more |= more;
      } else {
        const float between = gapBetween(supports_[at].box, ends[to].box) - 2 * limits_.body;
        if (to < supports_.size()) step.to = supports_[to].collider;
        step.blocked = partsNear(at, flight(at, mayLeap(supports_[at])), ends[to], between) > 0;
      }
      routes[to] = {all, false, step};
    }
  }
}

std::vector<uint32_t> ReachBound::reached() const {
  std::vector<uint32_t> colliders;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if ((wild_ || isReached(i)) && supports_[i].carries) colliders.push_back(supports_[i].collider);
  }
  return colliders;
}

float ReachBound::secondsFor(float studs) const {
  if (wild_ || excess_ > 0) return 0;
  float pushes = 0;
  for (const Support& s : supports_) {
    if (s.beside != Beside::clear || s.pushes > 0 || s.leadsTo != level::kNone) return 0;
    if (s.carries) pushes += 2 * limits_.turned;
  }
  return std::max(studs - pushes, 0.0f) / limits_.walk;
}

}  // namespace obby::solve
