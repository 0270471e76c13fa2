// The simulator's host interface: make a world, advance it, hash it, replay a trajectory record.
// The rules themselves are the device headers beside this one (tick_phases.h and what it includes);
// search kernels include those directly.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/result.h"
#include "level/level.h"
#include "schema/obby.capnp.h"
#include "sim/loose.h"
#include "sim/world.h"

namespace obby::sim {

// A player standing (or falling) at the start, in full health.
World makeWorld(const level::LevelView& level, const level::StartPose& start);

// Its loose bodies: where the level has them, awake. Empty for levels without.
std::vector<LooseBody> makeLoose(const level::LevelView& level);

// The same as play begins. Where all of them come to rest by themselves within ten seconds they
// have done so: a server has run for longer before anybody plays. Else they are where the level has
// them.
std::vector<LooseBody> startLoose(const level::LevelView& level);

// Digest of every field of the state; equal on every machine for the same playthrough.
uint64_t stateHash(const World& world, std::span<const LooseBody> loose = {});

// Everything a trajectory record says about what to do, in plain form.
struct Plan {
  level::StartPose start;
  Turns yaw = 0;  // exact facing at the start
  std::vector<ActionRun> actions;
  uint16_t tricks = 0;  // Params::tricks
};

// Longest plan that is replayed: 4 hours of play.
constexpr uint64_t kMaxReplayTicks = 4ull * 3600 * 60;

// Errors: a start beyond the coordinates that mean anything; more than kMaxReplayTicks.
Result<Plan> planFromRecord(schema::Trajectory::Reader record);
void writePlan(const Plan& plan, schema::Trajectory::Builder to);

// Advances one tick under the query's rules; does nothing once the playthrough has ended. `loose`:
// (level.looseCount), null where that is 0. `query` may be null.
void advance(World& world, LooseBody* loose, const level::LevelView& level,
             const level::QueryView* query, Action action);

// The same for many worlds, world i with the bodies loose[i] under actions[i], in SIMD lanes
// (wide_tick.h). `loose` may be null where the level has no loose bodies.
void advanceAll(const level::LevelView& level, const level::QueryView* query,
                std::span<World* const> worlds, LooseBody* const* loose, const Action* actions);

// A state of a playthrough as a visit is shown it: valid until the visit returns.
struct Moment {
  uint32_t tick;                     // since the start, which is 0
  const World& before;               // one tick earlier; at the start the same as `world`
  const World& world;                // now
  std::span<const LooseBody> loose;  // now: (level.looseCount)
};

// Whether to go on.
using Visit = std::function<bool(const Moment&)>;

// The last state that a replay came to.
struct ReplayEnd {
  World world;
  std::vector<LooseBody> loose;
  uint32_t ticks = 0;  // since the start
};

// Shows every state of a playthrough, the start first, and keeps none. Stops where the playthrough
// or its plan ends, or `visit` says so.
ReplayEnd replay(const level::LevelView& level, const level::QueryView* query, const Plan& plan,
                 const Visit& visit);

// Every state of a playthrough, the start first: (ticks + 1) worlds, and as many times
// level.looseCount bodies. Four hours with 16 bodies are 900 MB: for short playthroughs, or for
// whoever asks for states in any order.
struct Replay {
  std::vector<World> worlds;
  std::vector<LooseBody> loose;

  std::span<const LooseBody> looseAt(size_t tick) const {
    const size_t count = loose.size() / worlds.size();
    return std::span(loose).subspan(tick * count, count);
  }
};

// All that the other shows to a visit that never stops.
Replay replay(const level::LevelView& level, const level::QueryView* query, const Plan& plan);

}  // namespace obby::sim
