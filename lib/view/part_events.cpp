// Parts that do the same at the same time are looked at together, and only when their clock runs.
#include "view/part_events.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "sim/clocks.h"

namespace obby::view {
namespace {

struct Group {
  uint32_t collider;            // of the first of its parts
  int64_t now;                  // what was told of them last
  std::vector<uint32_t> parts;  // ascending
};

// By the clock, the tick of it from which on something is so, and whether it is the other way
// round.
using GroupKey = std::tuple<uint32_t, uint32_t, bool>;
using Groups = std::map<GroupKey, Group>;

// The parts that have the flag, each once: hulls of one part share its role and mover. `first`:
// what holds before the playthrough.
template <class KeyOf>
Groups groupsOf(const level::LevelView& view, uint32_t flag, int64_t first, const KeyOf& keyOf) {
  Groups groups;
  uint32_t before = level::kNone;
  for (uint32_t i = 0; i < view.colliderCount; ++i) {
    const level::Collider& c = view.colliders[i];
    if ((view.bounds[i].flags & flag) == 0 || c.part == before) continue;
    before = c.part;
    groups.try_emplace(keyOf(c), Group{i, first, {}}).first->second.parts.push_back(c.part);
  }
  return groups;
}

// Whenever `valueOf` (tick, collider) of a group is another than in the tick before: its parts,
// with the new value. `cut` is set if these are more than `most`.
template <class ValueOf>
std::vector<MotionEvent> changesOf(const std::vector<sim::World>& worlds, Groups groups,
                                   const ValueOf& valueOf, size_t most, bool& cut) {
  std::vector<MotionEvent> changes;
  const auto look = [&](uint32_t tick, Group& group) {
    const int64_t now = valueOf(tick, group.collider);
    if (now == std::exchange(group.now, now)) return;
    for (const uint32_t part : group.parts) changes.push_back({tick, part, now});
  };
  const auto lookAtClock = [&](uint32_t tick, uint32_t clock) {
    auto at = groups.lower_bound(GroupKey{clock, 0, false});
    for (; at != groups.end() && std::get<0>(at->first) == clock; ++at) look(tick, at->second);
  };
  for (uint32_t tick = 0; tick < worlds.size() && !groups.empty(); ++tick) {
    const auto before = std::ptrdiff_t(changes.size());
    if (tick == 0) {
      for (auto& [key, group] : groups) look(tick, group);
    } else {
      // What no clock moves that runs in this tick or ran in the one before is as it was.
      for (const sim::World* w : {&worlds[tick - 1], &worlds[tick]}) {
        for (int i = 0; i < w->clockCount; ++i) lookAtClock(tick, w->clocks[i].clock);
      }
    }
    std::sort(changes.begin() + before, changes.end(),
              [](const MotionEvent& a, const MotionEvent& b) { return a.part < b.part; });
    if (changes.size() <= most) continue;
    changes.erase(changes.begin() + before, changes.end());
    cut = true;
    break;
  }
  return changes;
}

}  // namespace

PartEvents partEventsOf(const std::vector<sim::World>& worlds, const level::LevelView& view,
                        size_t most) {
  PartEvents out;
  const auto clockOfRole = [&](const level::Collider& c) {
    const level::Roles& r = view.roles[c.role];
    return GroupKey{r.awayClock, r.awayFrom, r.vanishInverted};
  };
  const auto away = [&](uint32_t tick, uint32_t collider) {
    const uint32_t role = view.colliders[collider].role;
    return int64_t(sim::isAway(worlds[tick], view, role, level::kClocked));
  };
  for (const MotionEvent& change :
       changesOf(worlds, groupsOf(view, level::kClocked, 0, clockOfRole), away, most, out.cut)) {
    out.events.push_back({change.tick, change.part, change.start == 0});
  }
  const auto clockOfMover = [&](const level::Collider& c) {
    return GroupKey{view.movers[c.mover].trigger, 0, false};
  };
  const auto start = [&](uint32_t tick, uint32_t collider) {
    const sim::World& w = worlds[tick];
    const int clock = sim::findClock(w, view.movers[view.colliders[collider].mover].trigger);
    return clock < 0 ? kRests : int64_t(tick) - w.clocks[clock].ticks;
  };
  out.motions = changesOf(worlds, groupsOf(view, level::kTriggered, kRests, clockOfMover), start,
                          most, out.cut);
  return out;
}

}  // namespace obby::view
