// Decides the order of a tick's phases. Each phase is a header of its own. This header is large: it
// is for kernels and the few sources of lib/sim that need the phases themselves. All others include
// tick.h.
#pragma once

#include "sim/air_jump.h"
#include "sim/body_player.h"
#include "sim/climb.h"
#include "sim/squeeze.h"
#include "sim/touch.h"
#include "sim/trip.h"

namespace obby::sim {

// Returns the health after a tick without harm.
template <class F>
OBBY_DEVICE F regenerated(F health, const Params& p) {
  const F more = minf(F(p.maxHealth), health + p.healthRegeneration * p.maxHealth * p.tickSeconds);
  return select(health < p.maxHealth, more, health);
}

// Applies the effects of the player's position at the end of a tick.
OBBY_DEVICE void endTick(World& w, const level::LevelView& level, const Candidates& near) {
  runClocks(w, level);
  touchParts(w, level, near);
  if (w.hurtTicks > 0) --w.hurtTicks;
  w.health = regenerated(w.health, level.params);
  w.tick += 1;
  if (w.outcome == Outcome::running && w.position.y < level.params.fallenPartsHeight) {
    w.state = State::dead;
    w.outcome = Outcome::fell;
  }
}

// The phases exist with and without dynamic bodies. GPUs use kDynamic = false for levels without
// dynamic bodies, because code that never runs still costs registers.

// Advances a player who is not seated by a tick. `p` includes the player's boosts.
template <bool kDynamic>
OBBY_DEVICE void move(World& w, RigidBody* bodies, const level::LevelView& level, const Params& p,
                      Candidates& near, const ControlT<float>& control) {
  Player player = playerOf(w);
  faceAtOnce(player, p, control);
  const Floor floor = senseFloor(w, bodies, player, level, near);
  updateState(player, p, floor, control);
  jumpInAir(w, player, level, p, control);
  const Truss truss = updateClimbing(w, bodies, player, level, p, near, floor, control);
  const bool climbs = player.is(State::climbing);
  turn(player, p, floor, climbs ? facing(truss, control) : control);
  const bool down = player.is(State::fallingDown);
  Motion motion = motionOf(player, p, floor,
                           down ? slideDown(player, p, floor) : drive(player, p, floor, control));
  motion.bottom = bodyBottom(State(player.state), p);
  near.footedOn = footedOn<float>(motion.drive.hover, floor);
  if (climbs) moveClimber(motion, truss, control, level, p, near);
  // A player near no body moves as if there were none.
  const bool among = (near.anyFlags & level::kDynamic) != 0;
  if (kDynamic && wakeTouched(w, bodies, floor, motion, level, near)) {
    moveTogether(w, bodies, among && !climbs ? &motion : nullptr, floor, level, near);
    if (!climbs && !among) moveBody(motion, level, near);
  } else if (!climbs) {
    moveBody(motion, level, near);
  }
  player.position = motion.position;
  player.velocity = motion.velocity;
  player.lifted = legsLift(motion.drive.hover, motion.velocity.y, motion.floorSpeed);
  putPlayer(w, player);
}

// Advances a world by one tick. `p` includes the player's boosts. tick() explains `apart`.
template <bool kDynamic>
OBBY_DEVICE void tickWith(World& w, RigidBody* bodies, const level::LevelView& level,
                          const Params& p, ControlT<float> control, uint32_t apart) {
  Candidates near;
  near.bodiesApart = apart;
  gather(w, bodies, level, p, near);
  if (w.state == State::seated) {
    if (kDynamic && (w.flags & kBodyAwake)) moveTogether(w, bodies, nullptr, {}, level, near);
    sit(w, kDynamic ? bodies : nullptr, level, p, control.jump);
    keepAirJumps(w, level, 0, control.jump);
  } else {
    move<kDynamic>(w, bodies, level, p, near, control);
    squeeze(w, level, near);
  }
  if (w.outcome == Outcome::running) {
    endTick(w, level, near);
  } else {
    w.tick += 1;
  }
}

// Implements tick() (tick.h) in place.
template <bool kDynamic>
OBBY_DEVICE void tickInPlace(World& w, RigidBody* bodies, const level::LevelView& level,
                             Action action, uint32_t apart) {
  if (w.outcome != Outcome::running) return;
  ControlT<float> control = controlOf(action, level.params);
  Params boosts;
  const Params* p = &level.params;
  bool helpless = false;
  if (w.clockCount != 0) {
    boosts = boosted(w, level);
    p = &boosts;
    helpless = isHelpless(w, level);
    if (helpless) control = {};
  }
  updateFallingDown(w, helpless);
  tickWith<kDynamic>(w, bodies, level, *p, control, apart);
}

}  // namespace obby::sim
