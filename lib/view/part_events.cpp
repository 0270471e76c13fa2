// Parts that change together form a group, and a group is examined only while its clock runs.
#include "view/part_events.h"

#include <algorithm>
#include <utility>

#include "sim/clocks.h"

namespace obby::view {

// Returns groups of the parts with a flag, each part once: the hulls of one part share its role and
// mover. `first`: value before the trajectory.
template <class KeyOf>
PartWatch::Groups PartWatch::groupsOf(uint32_t flag, int64_t first, const KeyOf& keyOf) const {
  Groups groups;
  uint32_t before = level::kNone;
  for (uint32_t i = 0; i < view_.colliderCount; ++i) {
    const level::Collider& c = view_.colliders[i];
    if ((view_.bounds[i].flags & flag) == 0 || c.part == before) continue;
    before = c.part;
    groups.try_emplace(keyOf(c), Group{i, first, {}}).first->second.parts.push_back(c.part);
  }
  return groups;
}

PartWatch::PartWatch(const level::LevelView& view, size_t max) : view_(view), max_(max) {
  away_.groups = groupsOf(level::kClocked, 0, [&](const level::Collider& c) {
    const level::Roles& r = view.roles[c.role];
    return GroupKey{r.awayClock, r.awayFrom, r.vanishInverted};
  });
  starts_.groups = groupsOf(level::kTriggered, kRests, [&](const level::Collider& c) {
    return GroupKey{view.movers[c.mover].trigger, 0, false};
  });
}

// Adds a change for each part of the groups whose value differs from the tick before. `valueOf`
// takes a collider.
template <class ValueOf>
void PartWatch::note(Changes& changes, const sim::Moment& now, const ValueOf& valueOf) const {
  Groups& groups = changes.groups;
  if (groups.empty()) return;
  const auto before = std::ptrdiff_t(changes.list.size());
  const auto look = [&](Group& group) {
    const int64_t value = valueOf(group.collider);
    if (value == std::exchange(group.now, value)) return;
    for (const uint32_t part : group.parts) changes.list.push_back({now.tick, part, value});
  };
  const auto lookAtClock = [&](uint32_t clock) {
    auto at = groups.lower_bound(GroupKey{clock, 0, false});
    for (; at != groups.end() && std::get<0>(at->first) == clock; ++at) look(at->second);
  };
  if (now.tick == 0) {
    for (auto& [key, group] : groups) look(group);
  } else {
    // A value can change only by a clock that runs in this tick or ran in the one before.
    for (const sim::World* w : {&now.before, &now.world}) {
      for (int i = 0; i < w->clockCount; ++i) lookAtClock(w->clocks[i].clock);
    }
  }
  std::sort(changes.list.begin() + before, changes.list.end(),
            [](const MotionEvent& a, const MotionEvent& b) { return a.part < b.part; });
  if (changes.list.size() <= max_) return;
  changes.list.erase(changes.list.begin() + before, changes.list.end());
  changes.cut = true;
  groups.clear();
}

void PartWatch::see(const sim::Moment& now) {
  note(away_, now, [&](uint32_t collider) {
    const uint32_t role = view_.colliders[collider].role;
    return int64_t(sim::isAway(now.world, view_, role, level::kClocked));
  });
  note(starts_, now, [&](uint32_t collider) {
    const level::Mover& mover = view_.movers[view_.colliders[collider].mover];
    const int clock = sim::findClock(now.world, mover.trigger);
    return clock < 0 ? kRests : int64_t(now.tick) - now.world.clocks[clock].ticks;
  });
}

PartEvents PartWatch::take() {
  PartEvents out;
  for (const MotionEvent& change : away_.list) {
    out.events.push_back({change.tick, change.part, change.start == 0});
  }
  out.motions = std::move(starts_.list);
  out.cut = away_.cut || starts_.cut;
  return out;
}

}  // namespace obby::view
