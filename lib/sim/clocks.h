// Clocks that touches start, and their effects: on a part's presence, on the pose of a triggered
// part, on the player's speed and gravity. A clock that does not run has no effect.
#pragma once

#include "level/level_view.h"
#include "sim/world.h"

namespace obby::sim {

// Returns the clock's index among the running clocks, or -1 if it does not run.
OBBY_DEVICE int findClock(const World& w, uint32_t clock) {
  for (int i = 0; i < w.clockCount; ++i) {
    if (w.clocks[i].clock == clock) return i;
  }
  return -1;
}

// Stops a clock. The order of the others is kept.
OBBY_DEVICE void stopClock(World& w, uint32_t clock) {
  int kept = 0;
  for (int i = 0; i < w.clockCount; ++i) {
    if (w.clocks[i].clock != clock) w.clocks[kept++] = w.clocks[i];
  }
  w.clockCount = uint8_t(kept);
}

OBBY_DEVICE void startClock(World& w, const level::LevelView& level, uint32_t clock) {
  if (findClock(w, clock) >= 0) {
    if (!level.clocks[clock].restarts) return;
    stopClock(w, clock);
  }
  if (w.clockCount == kMaxClocks) {
    w.flags |= kClockOverrun;
    return;
  }
  w.clocks[w.clockCount++] = {clock, 0};
}

// Advances the clocks by a tick, and removes those that are over. The order is kept.
OBBY_DEVICE void runClocks(World& w, const level::LevelView& level) {
  int kept = 0;
  for (int i = 0; i < w.clockCount; ++i) {
    const RunningClock c{w.clocks[i].clock, w.clocks[i].ticks + 1};
    if (c.ticks < level.clocks[c.clock].length) w.clocks[kept++] = c;
  }
  w.clockCount = uint8_t(kept);
}

// Returns true if a part has no collision in this tick.
OBBY_DEVICE bool isAway(const World& w, const level::LevelView& level, uint32_t role,
                        uint32_t flags) {
  const level::Roles& r = level.roles[role];
  bool away = false;
  if (flags & level::kVanishTimer) {
    away = (w.tick + r.vanishPhase) % (r.vanishDelay + r.vanishAway) >= r.vanishDelay;
  } else {
    const int i = findClock(w, r.awayClock);
    away = i >= 0 && w.clocks[i].ticks >= r.awayFrom;
  }
  return away != r.vanishInverted;
}

// Returns the pose of a moving part `later` ticks (0 or 1) after the state `w`, while no clock
// starts or ends.
OBBY_DEVICE Pose poseOf(const level::Mover& m, const World& w, uint32_t later) {
  if (m.trigger == level::kNone) return moverPose(m, w.tick + later);
  const int i = findClock(w, m.trigger);
  return moverPose(m, i < 0 ? 0 : w.clocks[i].ticks + later);
}

// Returns the physics of a player under the running boosts. If several change the same
// value, the one started last counts.
OBBY_DEVICE Params boosted(const World& w, const level::LevelView& level) {
  Params p = level.params;
  for (int i = 0; i < w.clockCount; ++i) {
    const level::Clock& c = level.clocks[w.clocks[i].clock];
    if (changesWalk(c)) p.walkSpeed = level.params.walkSpeed * c.walkFactor;
    if (changesJump(c)) p.jumpSpeed = jumpSpeedUnder(c, level.params);
    if (changesGravity(c)) p.gravity = level.params.gravity * c.gravityFactor;
  }
  return p;
}

// Returns true if the player has lost control.
OBBY_DEVICE bool isHelpless(const World& w, const level::LevelView& level) {
  for (int i = 0; i < w.clockCount; ++i) {
    if (w.clocks[i].ticks < level.clocks[w.clocks[i].clock].helpless) return true;
  }
  return false;
}

}  // namespace obby::sim
