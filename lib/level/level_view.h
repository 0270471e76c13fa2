// The compiled level as the simulator reads it: plain spans, shared by all worlds, valid on host
// and device. level::Level owns the tables.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "geom/shape.h"
#include "level/params.h"
#include "math/angle.h"

namespace obby::level {

constexpr uint32_t kNone = 0xffffffffu;

// The effects of a collider on a player, one bit each.
enum ColliderFlag : uint32_t {
  kSolid = 1,
  kKill = 2,
  kPad = 4,
  kConveyor = 8,
  kClocked = 16,      // solidity depends on a running clock
  kVanishTimer = 32,  // solidity depends on the level's clock
  kMoving = 64,
  kCarries = 128,     // a moving part that carries a player who stands on it
  kUpright = 256,     // a block whose local Y is the world's Y: fewer axes to test
  kBlock = 512,       // a block or a truss, the shape that lanes can test
  kTruss = 1024,      // can be climbed
  kStarts = 2048,     // starts clocks when touched
  kTriggered = 4096,  // a moving part that a clock moves
  kTeleport = 8192,
  kHeal = 16384,
  kOneWay = 32768,  // solid from one side only
  kCrush = 65536,   // kills players whom it squeezes
  kSeat = 131072,
  kRung = 524288,     // a truss so thin that the sensor must search for it
  kDynamic = 262144,  // part of a dynamic body
  kByRoot = 1048576,  // touched by the centre of the root, not by limbs
};
constexpr uint32_t kTouchRoles = kKill | kPad | kStarts | kTeleport | kHeal | kSeat;

// One convex shape. A part has one, or one for each of its hulls. Pose and half extents share a
// cache line, which the wide tick loads as a row.
struct alignas(64) Collider {
  Pose pose;  // pose of a part without a mover
  geom::ShapeData shape;
  uint32_t part;     // index into the level's parts
  uint32_t mover;    // index into movers, or kNone
  uint32_t role;     // index into roles, or kNone
  float friction;    // 0 to 100
  float grip;        // friction with the player: the weighted mean of both
  float elasticity;  // 0 to 1
  geom::ShapeKind kind;
  uint8_t body;  // index into LevelView::bodies, or kNoBody
};
constexpr uint8_t kNoBody = 0xff;

template <class Table>
OBBY_DEVICE void forTables(Collider& c, Table&& table) {
  table(c.shape.hull, 1);
}

// The data of a collider that a search for nearby parts reads. The upper corner is negated, so that
// one comparison of eight numbers tests for an overlap. The comparison reads flags and tag as tiny
// floats.
struct alignas(32) Bounds {
  Vec3 lo, minusHi;
  uint32_t flags;  // ColliderFlag bits
  uint32_t tag;    // index << kTagShift, and the tag bits below

  OBBY_DEVICE Box box() const { return {lo, -minusHi}; }
};
constexpr uint32_t kSolidTag = 1, kUprightTag = 2, kMovingTag = 4;
constexpr uint32_t kSurfaceTag = 8;  // carries, conveys or is slippery
constexpr int kTagShift = 4;

OBBY_DEVICE Bounds makeBounds(const Box& box, uint32_t flags, uint32_t index, bool slippery) {
  uint32_t tag = index << kTagShift;
  if (flags & kSolid) tag |= kSolidTag;
  if (flags & kUpright) tag |= kUprightTag;
  if (flags & kMoving) tag |= kMovingTag;
  if (slippery || (flags & (kConveyor | kCarries))) tag |= kSurfaceTag;
  return {box.lo, -box.hi, flags, tag};
}

// A clock that a touch starts. Clock i is the own clock of role i. Later clocks are shared by
// several parts: signals and boosts.
struct Clock {
  uint32_t length = 0;    // ticks, or kForever
  bool restarts = false;  // a touch while the clock runs starts it again
  // Effects on the player while it runs.
  float walkFactor = 1;     // factor of walkSpeed
  float jumpFactor = 1;     // factor of jumpSpeed
  float jumpMore = 0;       // studs/s added to the jump speed
  float gravityFactor = 1;  // factor of gravity
  bool resets = false;      // values that the clock does not change return to the level's
  uint32_t helpless = 0;    // ticks from the clock's start during which keys do nothing
  uint32_t seat = kNone;    // collider on which the player sits while the clock is held at 0
};
constexpr uint32_t kForever = 0xffffffffu;

// Returns the launch speed of a jump while the clock runs, studs/s.
OBBY_DEVICE float jumpSpeedUnder(const Clock& c, const Params& p) {
  return maxf(p.jumpSpeed * c.jumpFactor + c.jumpMore, 0.0f);
}
OBBY_DEVICE bool changesWalk(const Clock& c) { return c.resets || c.walkFactor != 1; }
OBBY_DEVICE bool changesJump(const Clock& c) {
  return c.resets || c.jumpFactor != 1 || c.jumpMore != 0;
}
OBBY_DEVICE bool changesGravity(const Clock& c) { return c.resets || c.gravityFactor != 1; }

constexpr int kMaxStarts = 4;  // max clocks that a touch of one part can start; others are left out

// One record for each part that has a role, shared by its colliders.
struct Roles {
  float damage;            // health that a touch takes; negative if it heals
  uint16_t cooldownTicks;  // ticks between two hits
  bool padKeepsSideways;
  Vec3 padVelocity;       // studs/s
  Vec3 conveyorVelocity;  // studs/s
  Vec3 conveyorAngular;   // rad/s about the part's present centre
  uint32_t vanishDelay;   // ticks; for a timer the solid ticks of each period
  uint32_t vanishAway;    // ticks without collision after that
  uint32_t vanishPhase;   // ticks, timer only
  bool vanishInverted;    // solid only while it would otherwise be away
  // The part is away while this clock runs, from `awayFrom` ticks after its start.
  uint32_t awayClock;
  uint32_t awayFrom;
  uint32_t starts[kMaxStarts];  // clocks that a touch starts; kNone if unused
  uint32_t healClock;           // no healing while this clock runs; if kNone, every touch heals
  Vec3 teleportTo;              // position of the feet
  Turns teleportYaw;
  bool teleportTurns, teleportKeepsVelocity;
  Vec3 oneWay;         // unit, in the part's frame, toward the side that is solid
  uint32_t seatClock;  // clock held at 0 while the player sits here; kNone if the part is no seat
};

// Returns the velocity of a conveyor's surface at a point. `center` is the part's present centre.
OBBY_DEVICE Vec3 conveyorVelocityAt(const Roles& r, Vec3 center, Vec3 point) {
  return r.conveyorVelocity + cross(r.conveyorAngular, point - center);
}

// A moving part. Its pose at tick t, of the level's clock or of its trigger, is keys[wrap(t,
// keyCount)] turned by spins[t % spinCount] about the pivot. Tables hold whole repetitions, so that
// a period that is not a whole number of ticks does not drift (motion_tables.h).
struct Mover {
  const Pose* keys;   // (keyCount), at least 1
  const Mat3* spins;  // (spinCount), may be null
  uint32_t keyCount;
  uint32_t spinCount;
  Vec3 pivot;  // studs from the part's centre, in the part's frame
  bool once;   // stays at the last key instead of starting over
  // Clock that moves the part; while the clock does not run, the part rests at tick 0.
  uint32_t trigger = kNone;
};

template <class Table>
OBBY_DEVICE void forTables(Mover& m, Table&& table) {
  table(m.keys, m.keyCount);
  table(m.spins, m.spinCount);
}

// Returns the part's pose `tick` ticks after the start of its motion.
OBBY_DEVICE Pose moverPose(const Mover& m, uint32_t tick) {
  const uint32_t k = m.once ? (tick < m.keyCount ? tick : m.keyCount - 1) : tick % m.keyCount;
  Pose pose = m.keys[k];
  if (m.spinCount != 0) {
    const Vec3 pivot = toWorld(pose, m.pivot);
    pose.rotation = pose.rotation * m.spins[tick % m.spinCount];
    pose.position = pivot - pose.rotation * m.pivot;
  }
  return pose;
}

// A dynamic body: an unanchored part that physics moves. Each world has its state, a
// sim::RigidBody. Its colliders are in the table of colliders, but in no grid.
struct DynamicBody {
  Vec3 position;  // position of the part at the start
  Quat rotation;
  Vec3 center;          // centre of mass, studs, in the part's frame
  Mat3 inverseInertia;  // 1 / (mass studs^2), about the centre, in the part's frame
  float inverseMass;    // mass is density x cubic studs
  float radius;         // studs around the centre that contain all of it
  uint32_t firstCollider, colliderCount;
};
constexpr int kMaxBodies = 16;  // dynamic bodies of a level; more of them are an error

constexpr uint32_t kListStep = 4;

// Uniform grid over positions of the feet. The list of a cell names every collider that a player
// with the feet in the cell can meet within one tick. One look-up is therefore enough
// (grid_build.h).
struct Grid {
  Vec3 origin;
  Vec3 inverseCell;  // 1 / cell extent
  int32_t nx, ny, nz;
  const uint32_t* cells;  // (nx * ny * nz), where each cell's list starts in `lists`
  const uint32_t* lists;  // each list: count, then collider indices in ascending order, padded with
                          // colliderCount to a multiple of kListStep; before it, at -2 and -1, the
                          // flags of any and of every collider in it
  uint32_t listWords;     // words of all lists together
};

struct LevelView {
  Params params;
  const Collider* colliders;  // (colliderCount)
  const Bounds* bounds;  // (colliderCount + 1), swept bounds for moving colliders; the last one
                         // meets nothing
  const Roles* roles;    // (roleCount)
  const Mover* movers;   // (moverCount)
  const Clock* clocks;   // (clockCount)
  const DynamicBody* bodies;  // (bodyCount)
  uint32_t colliderCount, roleCount, moverCount, clockCount, bodyCount;
  uint32_t crushClock;  // counts the ticks of a squeeze; kNone if no part crushes
  uint32_t airClock;    // counts jumps in the air (sim/air_jump.h); kNone if not allowed
  Grid grid;
  Grid bodyGrid;  // grid over the centres of dynamic bodies; empty if there are none
  // Studs/s; the grid's lists cover the distance that a player moves in a tick at this speed.
  float maxSideSpeed;
};

template <class Table>
OBBY_DEVICE void forTables(Grid& g, Table&& table) {
  table(g.cells, size_t(g.nx) * g.ny * g.nz);
  table(g.lists, g.listWords);
}

template <class Table>
OBBY_DEVICE void forTables(LevelView& v, Table&& table) {
  table(v.colliders, v.colliderCount);
  table(v.bounds, v.colliderCount + 1);
  table(v.roles, v.roleCount);
  table(v.movers, v.moverCount);
  table(v.clocks, v.clockCount);
  table(v.bodies, v.bodyCount);
  forTables(v.grid, table);
  forTables(v.bodyGrid, table);
}

}  // namespace obby::level
