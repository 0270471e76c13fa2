// The data that random exploration reads besides the world: the problem, the surfaces to aim at,
// and how far this level's player can jump. Plain data, for device code.
#pragma once

#include <stdint.h>

#include "policy/pilot_view.h"
#include "solve/model/targets.h"
#include "solve/search/rollouts/surface_view.h"

namespace obby::solve {

// The reach of one jump on level ground.
struct JumpReach {
  float airTicks;  // ticks from launch to landing at the same height
  float distance;  // studs sideways in that time, at walking speed
  float height;    // studs, of the feet
};

OBBY_DEVICE JumpReach jumpReach(const Params& p) {
  const float gravity = maxf(p.gravity, 1.0f);
  const float seconds = minf(2 * p.jumpSpeed / gravity, 5.0f);
  return {seconds * float(p.controlRate), seconds * p.walkSpeed,
          riseOfLaunch(p, gravity, p.jumpSpeed)};
}

// Settings of how rollouts explore, from a method's row.
struct ExploreSettings {
  float aimShare = 0.8f;     // share of macros that aim at a surface or the next region
  float regionShare = 0.3f;  // share of aimed macros that aim at the next region
};

struct ExploreContext {
  level::LevelView level;
  level::QueryView query;
  SurfaceView surfaces;
  JumpReach reach;
  ExploreSettings settings;
  bool jumpsLimited;
  float fatalHeight;          // studs; a player off the floor with lower feet can only fall
  policy::PilotView pilot{};  // makes the policy's moves, if there is a policy
};

template <class Table>
OBBY_DEVICE void forTables(ExploreContext& c, Table&& table) {
  forTables(c.level, table);
  forTables(c.query, table);
  forTables(c.surfaces, table);
  forTables(c.pilot, table);
}

// Returns the reach under the boosts that the player has now.
OBBY_DEVICE JumpReach reachIn(const ExploreContext& c, const sim::World& w) {
  return w.clockCount == 0 ? c.reach : jumpReach(sim::boosted(w, c.level));
}

// Returns true if the player is below everything and can only fall.
OBBY_DEVICE bool doomed(const ExploreContext& c, const sim::World& w) {
  return w.position.y < c.fatalHeight && w.floorlessSteps > c.level.params.coyoteSteps;
}

// Returns true if a rollout that stopped here ends as a fall.
OBBY_DEVICE bool fallsOn(const ExploreContext& c, const sim::World& w) {
  return w.outcome == sim::Outcome::running && doomed(c, w);
}

constexpr uint32_t kFallTicks = 60 * 3600;  // longer than any fall

// Returns true if the player stands on something, hangs on a truss or sits, and is free to jump
// soon. It has no branches, since searches call it for every world at every tick.
OBBY_DEVICE bool grounded(const sim::World& w) {
  using sim::State;
  const auto in = [&](State s) { return uint32_t(w.state == s); };
  const uint32_t holds = in(State::climbing) | in(State::seated);
  const uint32_t off =
      in(State::jumping) | in(State::freefall) | in(State::dead) | in(State::fallingDown);
  return (holds | (uint32_t(w.floorlessSteps == 0) & (off ^ 1u))) != 0;
}

}  // namespace obby::solve
