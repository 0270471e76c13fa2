// The simulator's host interface: make a world, advance it, hash it, replay a trajectory record.
// The rules themselves are the device headers beside this one (tick.h and what it includes); search
// kernels include those directly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "sim/world.h"

namespace obby::sim {

// A player standing (or falling) at the start, in full health.
World makeWorld(const level::LevelView& level, const level::StartPose& start);

// Digest of every field of the state; equal on every machine for the same playthrough.
uint64_t stateHash(const World& world);

// Everything a trajectory record says about what to do, in plain form.
struct Plan {
  level::StartPose start;
  Turns yaw = 0;  // exact facing at the start
  std::vector<ActionRun> actions;
};

// Longest plan that is replayed: 4 hours of play.
constexpr uint64_t kMaxReplayTicks = 4ull * 3600 * 60;

Result<Plan> planFromRecord(schema::Trajectory::Reader record);

// Advances one tick under the query's rules; does nothing once the playthrough has ended. `query`
// may be null.
void advance(World& world, const level::LevelView& level, const level::QueryView* query,
             Action action);

// The same for many worlds, world i under actions[i], in SIMD lanes (wide_tick.h).
void advanceAll(const level::LevelView& level, const level::QueryView* query,
                std::span<World* const> worlds, const Action* actions);

// The world after each tick of the plan, the start first: (ticks + 1). Stops where the playthrough
// ends.
std::vector<World> replay(const level::LevelView& level, const level::QueryView* query,
                          const Plan& plan);

}  // namespace obby::sim
