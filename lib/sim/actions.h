// Sources of the actions of many worlds during a launch of several ticks: a table, a plan for each
// world, or a walker that draws them. CPU and GPU share this code.
#pragma once

#include <stddef.h>

#include "base/random.h"
#include "sim/world.h"

namespace obby::sim {

enum class ActionKind : uint8_t { walker, table, plans };

struct ActionView {
  ActionKind kind = ActionKind::walker;
  uint64_t seed = 0;                 // seed of the walker
  const Action* table = nullptr;     // (ticks, worlds)
  const ActionRun* runs = nullptr;   // runs of the plans, world by world
  const uint32_t* firsts = nullptr;  // (worlds + 1), into runs
};

constexpr uint32_t kWalkerHold = 15;  // ticks that a walker holds an action

// Returns a random action, which depends only on seed, world, episode and tick. So worlds keep no
// state for it.
OBBY_DEVICE Action walkerAction(uint64_t seed, uint32_t world, uint32_t episode, uint32_t tick) {
  const uint64_t stream = (uint64_t(episode) << 44) + world * 1000000ull + tick / kWalkerHold;
  Random random(seed, stream);
  const Turns heading = Turns(random.next());
  const bool walk = random.below(8) != 0;
  return {heading, walk, random.below(3) == 0};
}

// A request for an action: world `world` of `worlds`, in its `episode`, after `tick` ticks of this
// step.
struct Asking {
  uint32_t world, worlds, episode, tick;
};

// Position of a world in its source of actions.
class ActionCursor {
 public:
  OBBY_DEVICE Action next(const ActionView& view, const Asking& who, uint32_t clock) {
    if (view.kind == ActionKind::table) {
      return view.table[size_t(who.tick) * who.worlds + who.world];
    }
    if (left_ == 0) take(view, who, clock);
    --left_;
    return held_;
  }

  // Called when the world starts over. A walker then draws a new action; plans and tables continue.
  OBBY_DEVICE void startOver(const ActionView& view) {
    if (view.kind == ActionKind::walker) left_ = 0;
  }

 private:
  OBBY_DEVICE void take(const ActionView& view, const Asking& who, uint32_t clock) {
    if (view.kind == ActionKind::walker) {
      held_ = walkerAction(view.seed, who.world, who.episode, clock);
      left_ = kWalkerHold - clock % kWalkerHold;
      return;
    }
    const uint32_t first = view.firsts[who.world], count = view.firsts[who.world + 1] - first;
    while (left_ == 0 && run_ < count) {
      held_ = view.runs[first + run_].action;
      left_ = view.runs[first + run_++].ticks;
    }
    if (left_ != 0) return;
    held_ = {};  // a world stands still after the end of its plan
    left_ = 0xffffffffu;
  }

  Action held_;
  uint32_t left_ = 0;
  uint32_t run_ = 0;  // index of the plan's next run
};

}  // namespace obby::sim
