// Changes of parts in a replay that touch-triggered clocks cause.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "level/level_view.h"
#include "sim/simulator.h"

namespace obby::view {

// A part loses or regains its collision.
struct PartEvent {
  uint32_t tick;  // ticks since the trajectory's start
  uint32_t part;
  bool solid;
};

// A triggered part starts to move, restarts, or comes to rest.
struct MotionEvent {
  uint32_t tick;  // ticks since the trajectory's start
  uint32_t part;
  int64_t start;  // tick at which the part's motion begins, or kRests
};
constexpr int64_t kRests = -1;

// Max events of each kind kept for a trajectory. A single button may affect thousands of parts, for
// hours.
constexpr size_t kMaxPartEvents = 1'000'000;

// The events of a replay. Both lists are sorted by tick, then by part.
struct PartEvents {
  std::vector<PartEvent> events;
  std::vector<MotionEvent> motions;
  bool cut = false;  // one kind exceeded its limit; its later events are missing
};

// Records events during a replay. The time depends on ticks and events, not on the level's number
// of parts.
class PartWatch {
 public:
  // The level must outlive this object. `max`: limit of each kind; whole ticks are kept.
  explicit PartWatch(const level::LevelView& view, size_t max = kMaxPartEvents);

  // Expects every moment of the trajectory, in order.
  void see(const sim::Moment& now);

  // Returns the events. The object is used up.
  PartEvents take();

 private:
  // Parts that always change together.
  struct Group {
    uint32_t collider;            // collider of its first part
    int64_t now;                  // last recorded value
    std::vector<uint32_t> parts;  // ascending
  };
  // Clock, clock tick of the change, and whether it is inverted.
  using GroupKey = std::tuple<uint32_t, uint32_t, bool>;
  using Groups = std::map<GroupKey, Group>;
  // Changes of one kind, and the current values.
  struct Changes {
    Groups groups;  // empty once there are too many changes
    std::vector<MotionEvent> list;
    bool cut = false;
  };

  template <class KeyOf>
  Groups groupsOf(uint32_t flag, int64_t first, const KeyOf& keyOf) const;
  template <class ValueOf>
  void note(Changes& changes, const sim::Moment& now, const ValueOf& valueOf) const;

  const level::LevelView& view_;
  size_t max_;
  Changes away_, starts_;
};

}  // namespace obby::view
