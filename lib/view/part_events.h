// What the clocks that touches start do to parts during a playthrough.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "level/level_view.h"
#include "sim/simulator.h"

namespace obby::view {

// A part that loses (or gets back) its collision during a playthrough.
struct PartEvent {
  uint32_t tick;  // since the start of the playthrough
  uint32_t part;
  bool solid;
};

// A triggered part starts to move, starts anew, or rests again.
struct MotionEvent {
  uint32_t tick;  // since the start of the playthrough
  uint32_t part;
  int64_t start;  // tick at which its motion is at its beginning, or kRests
};
constexpr int64_t kRests = -1;

// Of either kind, that are kept of a playthrough: one button may bring thousands of parts, for
// hours.
constexpr size_t kMostPartEvents = 1'000'000;

// In the order of ticks, those of a tick in the order of parts.
struct PartEvents {
  std::vector<PartEvent> events;
  std::vector<MotionEvent> motions;
  bool cut = false;  // of one kind there are more, from some tick on, which are left out
};

// Gathers them while a playthrough is replayed. Takes a time that grows with its ticks and with
// what happens in it, not with the parts of the level.
class PartWatch {
 public:
  // The level must outlive it. `most`: of either kind to be kept, whole ticks.
  explicit PartWatch(const level::LevelView& view, size_t most = kMostPartEvents);

  // Every moment of the playthrough, in order.
  void see(const sim::Moment& now);

  // What it has gathered. It is used up.
  PartEvents take();

 private:
  // Parts that do the same at the same time.
  struct Group {
    uint32_t collider;            // of the first of its parts
    int64_t now;                  // what was told of them last
    std::vector<uint32_t> parts;  // ascending
  };
  // By the clock, the tick of it from which on something is so, and whether it is the other way
  // round.
  using GroupKey = std::tuple<uint32_t, uint32_t, bool>;
  using Groups = std::map<GroupKey, Group>;
  // What has changed of one kind, with what is so from then on.
  struct Changes {
    Groups groups;  // none once there are too many changes
    std::vector<MotionEvent> list;
    bool cut = false;
  };

  template <class KeyOf>
  Groups groupsOf(uint32_t flag, int64_t first, const KeyOf& keyOf) const;
  template <class ValueOf>
  void note(Changes& changes, const sim::Moment& now, const ValueOf& valueOf) const;

  const level::LevelView& view_;
  size_t most_;
  Changes away_, starts_;
};

}  // namespace obby::view
