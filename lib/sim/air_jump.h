// Jumps in the air, as scripts add them. A falling player may jump again on a new key press, up to
// airJumps times before landing. A clock of the level stores the count.
#pragma once

#include "sim/clocks.h"
#include "sim/humanoid.h"

namespace obby::sim {

// The clock's ticks hold the number of jumps in units of kAirJump, and the bit kJumpHeld if the key
// was held in the last tick. Elapsed ticks count in the bits below.
constexpr uint32_t kAirJump = 1u << 25, kJumpHeld = 1u << 24;

// Returns the air jumps since the last floor.
OBBY_DEVICE uint32_t airJumpsMade(const World& w, const level::LevelView& level) {
  const int i = findClock(w, level.airClock);
  return i < 0 ? 0 : w.clocks[i].ticks / kAirJump;
}

OBBY_DEVICE void keepAirJumps(World& w, const level::LevelView& level, uint32_t made, bool held) {
  if (level.airClock == level::kNone) return;
  const uint32_t ticks = made * kAirJump + (held ? kJumpHeld : 0);
  if (ticks == 0) return stopClock(w, level.airClock);
  startClock(w, level, level.airClock);
  const int i = findClock(w, level.airClock);
  if (i >= 0) w.clocks[i].ticks = ticks;
}

// Runs after updateState(). `p` includes the player's boosts.
OBBY_DEVICE void jumpInAir(World& w, Player& player, const level::LevelView& level, const Params& p,
                           const ControlT<float>& control) {
  if (level.airClock == level::kNone) return;
  const int i = findClock(w, level.airClock);
  const bool held = i >= 0 && (w.clocks[i].ticks & kJumpHeld) != 0;
  const bool falls = player.is(State::freefall);
  uint32_t made = falls || player.is(State::jumping) ? airJumpsMade(w, level) : 0;
  const bool left = made < p.airJumps || p.airJumps == kAnyAirJumps;
  if (falls && control.jump && !held && left) {
    if (made < kAnyAirJumps) ++made;
    player.state = int32_t(State::jumping);
    player.velocity.y = p.jumpSpeed;
    player.freeSteps = 1;
    player.landedSteps = 0;  // no held jump
    player.jumps = countedOn(player.jumps, 1);
  }
  keepAirJumps(w, level, made, control.jump);
}

}  // namespace obby::sim
