// What the bound on reach says of places and queries.
#include <algorithm>

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
    if (!s.carries || s.wild || s.takesAlong || s.beside != Beside::clear) return;
    const Vec3 x = problem_.level.colliders[s.collider].pose.rotation.x;
    const bool axial = std::min(absf(x.x), absf(x.z)) < 1e-5f;
    const bool inside = box.lo.x >= s.box.lo.x && box.hi.x <= s.box.hi.x &&
                        box.lo.z >= s.box.lo.z && box.hi.z <= s.box.hi.z;
    if (!axial || !inside || box.lo.y <= s.box.lo.y + 2 * limits_.slack) return;
    const float height = s.top - p_.hipHeight - limits_.slack;
    if (!(height > region.falling)) return;
    region.falling = region.leaping = height;
    region.support = i;
  });
}

ReachBound::End ReachBound::endAt(const level::TargetView& target) const {
  const Box box = boxOf(target);
  const float height = box.lo.y - p_.bodyTop;
  End end{box, height, height, 0, kNever};
  if (target.touchCount == 0) standOn(end);
  return end;
}

uint32_t ReachBound::jumpsTo(const level::TargetView& target) const {
  if (wild_) return 0;
  const End end = endAt(target);
  uint32_t fewest = kNever;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] >= fewest) continue;
    const Support& s = supports_[i];
    const Flight falling = fall(i), leaping = leap(i);
    const bool jumps = leaps(s) && jumps_[i] + 1 < fewest;
    const bool low = apex(falling) >= end.falling;
    if (!low && !(jumps && apex(leaping) >= end.leaping)) continue;
    const float way = wayTo(s, ridesFrom(s, 1e30f), end);
    if (low && crosses(i, falling, end, way)) {
      fewest = jumps_[i];
    } else if (jumps && crosses(i, leaping, end, way)) {
      fewest = limits_.heldSeconds > 0 ? jumps_[i] : jumps_[i] + 1;
    }
  }
  return fewest;
}

bool ReachBound::holds(Vec3 feet) const { return comesInto({{feet, feet}}); }

bool ReachBound::comesInto(const std::vector<Box>& places) const {
  if (wild_) return !places.empty();
  for (uint32_t i = 0; i < supports_.size() && !places.empty(); ++i) {
    if (!isReached(i)) continue;
    const Support& s = supports_[i];
    const Flight falling = fall(i), leaping = leap(i);
    const bool jumps = leaps(s);
    const std::vector<Ride> rides = ridesFrom(s, 1e30f);
    for (const Box& place : places) {
      const End end{place, place.lo.y, place.lo.y, 0, kNever};
      const float way = wayTo(s, rides, end);
      if (crosses(i, falling, end, way) || (jumps && crosses(i, leaping, end, way))) return true;
    }
  }
  return false;
}

Missing ReachBound::missing(const std::vector<const level::TargetView*>& targets) const {
  std::vector<std::pair<End, uint32_t>> ends;
  for (const level::TargetView* t : targets) ends.emplace_back(endAt(*t), level::kNone);
  for (uint32_t j = 0; j < supports_.size(); ++j) {
    if (!isReached(j) && supports_[j].collider != level::kNone) {
      ends.emplace_back(endAt(j), supports_[j].collider);
    }
  }
  Missing best;
  float least = 1e30f;
  for (uint32_t i = 0; i < supports_.size(); ++i) {
    if (!isReached(i)) continue;
    const Support& s = supports_[i];
    const Flight f = leaps(s) ? leap(i) : fall(i);
    const float high = apex(f);
    const std::vector<Ride> rides = ridesFrom(s, 1e30f);
    for (const auto& [end, collider] : ends) {
      const float height = f.leaps ? end.leaping : end.falling;
      const float rise = std::max(height - high, 0.0f);
      if (!(rise < least)) continue;
      const float own = wayTo(s, rides, end) + (s.side - f.radius);
      const float gap = std::max(own - std::max(reach(f, std::min(height, high)), 0.0f), 0.0f);
      if (!(rise + gap < least)) continue;
      least = rise + gap;
      best = {s.collider, collider, rise, gap};
    }
  }
  return best;
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
    if (s.beside != Beside::clear || s.takesAlong || s.leadsTo != level::kNone) return 0;
    if (s.carries) pushes += 2 * limits_.turned;
  }
  return std::max(studs - pushes, 0.0f) / limits_.walk;
}

}  // namespace obby::solve
