// The simulator's host interface: makes a world, advances it, hashes it, and replays a trajectory
// record. The rules themselves are in the device headers next to this one (tick_phases.h and its
// includes), which search kernels include directly.
//
//   sim::World world = sim::makeWorld(level.view(), level.spawns().at(0));
//   std::vector<sim::RigidBody> bodies = sim::startBodies(level.view());
//   const sim::Action north{0, true, false};
//   for (int tick = 0; tick < 60; ++tick) {
//     sim::advance(world, bodies.data(), level.view(), nullptr, north);
//   }
//   const Vec3 feet = world.position;  // after a second of walking
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "sim/rigid_body.h"
#include "sim/world.h"

namespace obby::sim {

// Returns a world with a player standing (or falling) at the start, in full health.
World makeWorld(const level::LevelView& level, const level::StartPose& start);

// Returns the level's dynamic bodies at their first positions, awake. Returns none if the level has
// none.
std::vector<RigidBody> makeBodies(const level::LevelView& level);

// Returns the dynamic bodies as play begins. If all come to rest by themselves within ten seconds,
// they are at rest: a server has run for longer before the first player joins. Otherwise they are
// at their first positions.
std::vector<RigidBody> startBodies(const level::LevelView& level);

// Returns a digest of every field of the state. It is equal on every machine for the same
// trajectory.
uint64_t stateHash(const World& world, std::span<const RigidBody> bodies = {});

// The contents of a trajectory record in plain form.
struct Plan {
  level::StartPose start;
  Turns yaw = 0;  // exact facing at the start
  std::vector<ActionRun> actions;
  uint16_t tricks = 0;  // Params::tricks
};

// Max length of a plan that is replayed: 4 hours of play.
constexpr uint64_t kMaxReplayTicks = 4ull * 3600 * 60;

// A start beyond the valid coordinates, an unknown trick, and more than kMaxReplayTicks are errors.
Result<Plan> planFromRecord(schema::Trajectory::Reader record);
// Sets the start, the actions and the tricks of a record.
void writePlan(const Plan& plan, schema::Trajectory::Builder to);

// Advances one tick under the query's rules. Does nothing once the trajectory has ended. `bodies`
// has level.bodyCount bodies, or is null if there are none. `query` may be null.
void advance(World& world, RigidBody* bodies, const level::LevelView& level,
             const level::QueryView* query, Action action);

// Advances many worlds in SIMD lanes (wide_tick.h), world i with bodies[i] under actions[i].
// `bodies` may be null if the level has no dynamic bodies.
void advanceAll(const level::LevelView& level, const level::QueryView* query,
                std::span<World* const> worlds, RigidBody* const* bodies, const Action* actions);

// A state of a replayed trajectory, valid until the visit returns.
struct Moment {
  uint32_t tick;                      // ticks since the start, which is 0
  const World& before;                // one tick earlier; at the start the same as `world`
  const World& world;                 // now
  std::span<const RigidBody> bodies;  // now: (level.bodyCount)
};

// A function that replay() calls for each state. It returns true to continue.
using Visit = std::function<bool(const Moment&)>;

// The last state of a replay.
struct ReplayEnd {
  World world;
  std::vector<RigidBody> bodies;
  uint32_t ticks = 0;  // ticks since the start
};

// Visits every state of a trajectory, the start first, and keeps none. Stops at the end of the
// trajectory or its plan, or if `visit` returns false.
ReplayEnd replay(const level::LevelView& level, const level::QueryView* query, const Plan& plan,
                 const Visit& visit);

// Every state of a trajectory, the start first: (ticks + 1) worlds, with level.bodyCount bodies
// each. Four hours with 16 bodies take 900 MB, so this is for short trajectories, or for access in
// any order.
struct Replay {
  std::vector<World> worlds;
  std::vector<RigidBody> bodies;

  std::span<const RigidBody> bodiesAtTick(size_t tick) const {
    const size_t count = bodies.size() / worlds.size();
    return std::span(bodies).subspan(tick * count, count);
  }
};

// Returns all states that the other overload visits.
Replay replay(const level::LevelView& level, const level::QueryView* query, const Plan& plan);

}  // namespace obby::sim
