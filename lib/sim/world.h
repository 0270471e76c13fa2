// The state of one running copy of the game: a player in a level. OBBY_WORLD_FIELDS declares it
// once; snapshot (plain copy), hash and comparison follow from it. 128 bytes.
#pragma once

#include <stdint.h>

#include "math/angle.h"

namespace obby::sim {

// Humanoid states that an obby needs (docs/physics.md, states).
enum class State : uint8_t {
  running,
  jumping,
  freefall,
  landed,
  dead,
  climbing,
  seated,
  fallingDown
};

// The end of a trajectory, in the order of the schema's Outcome.
enum class Outcome : uint8_t {
  running,
  goal,
  killed,
  fell,
  avoided,
  jumps,
  timeout,
  hurt,
  forbidden
};

// Conditions that do not stop a batch. They are part of the state and its hash. An answer's reason
// names the overruns.
enum Flag : uint8_t {
  kFloorSensed = 1,  // a floor was within reach in the last tick (hysteresis of the floor rays)
  kCandidateOverrun = 2,  // more parts near the player than a world can hold: raise kMaxCandidates
  kClockOverrun = 4,      // more running clocks than a world can hold: raise kMaxClocks
  kArrived = 8,           // was teleported, and has touched a teleporter in every tick since
  kBodyAwake = 16,        // a dynamic body is awake
  kContactOverrun = 32,   // more contacts of dynamic bodies than a tick can hold: raise
                          // kMaxBodyContacts
  kLegsLift = 64,         // the legs alone make the body rise
  kLeftTruss = 128,       // rises from a jump off a truss
};

// Flags that a PlayerT (player.h) holds as masks.
constexpr uint8_t kPlayerFlags = kFloorSensed | kLegsLift | kLeftTruss;

constexpr uint8_t kOverruns = kCandidateOverrun | kClockOverrun | kContactOverrun;

constexpr int kMaxClocks = 8;

// A clock that a touch has started (level::Clock).
struct RunningClock {
  uint32_t clock;  // index into LevelView::clocks
  uint32_t ticks;  // ticks since the clock's start
};

// X(type, name)
#define OBBY_WORLD_FIELDS(X)                                                                \
  X(Vec3, position)           /* of the feet, studs */                                      \
  X(Vec3, velocity)           /* studs/s */                                                 \
  X(float, health)            /* up to Params::maxHealth; dead at 0 */                      \
  X(uint32_t, tick)           /* level clock */                                             \
  X(uint32_t, part)           /* that killed the player; if outcome is */                   \
                              /* avoided, an index into avoid; or level::kNone */           \
  X(uint16_t, yaw)            /* facing, turns / 65536 */                                   \
  X(uint16_t, jumps)          /* made so far, saturating */                                 \
  X(uint16_t, floorlessSteps) /* physics steps since a floor was last sensed, saturating */ \
  X(uint16_t, hurtTicks)      /* until damage parts can hurt again */                       \
  X(uint8_t, landedSteps)     /* physics steps left of the Landed state */                  \
  X(uint8_t, waypoints)       /* of the query, reached so far */                            \
  X(State, state)                                                                           \
  X(Outcome, outcome)                                                                       \
  X(uint8_t, flags)                                                                         \
  X(uint8_t, clockCount)

// Progress of a trajectory in a query, and its cost. Part of the hash unless all fields are 0.
#define OBBY_PROGRESS_FIELDS(X)                                              \
  X(uint16_t, segmentJumps) /* jumps made on arrival at the last waypoint */ \
  X(uint32_t, segmentTick)  /* level clock then */                           \
  X(uint32_t, visited)      /* of the query's visits, a bit each */          \
  X(float, damage)          /* health lost to parts so far */

// The first cache line holds what every tick reads and writes, so that the wide tick loads it as a
// row.
struct alignas(64) World {
#define OBBY_WORLD_FIELD(type, name) type name;
  OBBY_WORLD_FIELDS(OBBY_WORLD_FIELD)
  OBBY_PROGRESS_FIELDS(OBBY_WORLD_FIELD)
#undef OBBY_WORLD_FIELD
  RunningClock clocks[kMaxClocks];  // the first clockCount run, in the order of their start
};

// The keys that the player holds during one tick. Headings are turns / 65536; 0 is -Z.
struct Action {
  Turns heading = 0;  // direction of the move keys
  bool walk = false;  // a move key is held
  bool jump = false;
};

// One action held for a number of ticks.
struct ActionRun {
  Action action;
  uint32_t ticks;
};

}  // namespace obby::sim
