// Assembles the tables of a level and owns them.
#include "level/level.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/hash.h"
#include "level/clocks.h"
#include "level/compile_parts.h"
#include "level/grid_build.h"
#include "level/record_values.h"
#include "level/speeds.h"

namespace obby::level {

struct Level::Impl {
  std::string name;
  PartTables tables;
  GridTables grid, bodyGrid;
  LevelView view{};
  std::vector<StartPose> spawns;
  uint64_t hash = 0;
  uint32_t period = 0;
};

namespace {

// Factor by which a player may exceed the sum of the walk speed and the parts' sideways speed.
constexpr float kSpeedMargin = 1.5f;

// Returns a reach that covers everything a player tests during a tick, at any speed. One grid
// look-up then serves a tick (tickBounds in sim/candidates.h; tests/level/grid_test.cpp compares
// the two).
Reach reachOf(const Params& p, float sideways, float jump) {
  const float limbs = maxf((p.armSpan + p.bodyDepth) * 0.5f + p.touchMargin,
                           p.climbReach + p.bodyWidth * p.floorRaySpread);
  const float step = sideways * kSpeedMargin * p.tickSeconds + 1;
  const float fall = (p.maxFallSpeed + jump) * p.tickSeconds + 1;
  const float below =
      maxf(0.0f, p.floorReachBase * p.rootHeight + farthestFloor(p) * p.hipHeight - p.hipHeight);
  return {limbs + step, below + fall, p.bodyTop + fall};
}

// Returns a reach that covers everything a dynamic body can meet during a tick.
Reach dynamicReach(const PartTables& tables, const Params& p) {
  float radius = 0;
  for (const DynamicBody& l : tables.bodies) radius = maxf(radius, l.radius);
  const float reach = radius + p.maxFallSpeed * p.tickSeconds + 1;
  return {reach, reach, reach};
}

Grid gridOf(const GridTables& g) {
  if (g.cells.empty()) return {};
  return {g.origin,       {1 / g.cell.x, 1 / g.cell.y, 1 / g.cell.z},
          g.nx,           g.ny,
          g.nz,           g.cells.data(),
          g.lists.data(), uint32_t(g.lists.size())};
}

Status compileSpawns(schema::Level::Reader record, std::vector<StartPose>& spawns) {
  for (const auto spawn : record.getSpawns()) {
    const std::string path = fmt::format("spawns[{}]", spawns.size());
    OBBY_ASSIGN(const Vec3 feet, position(spawn.getPosition(), path + ".position"));
    OBBY_ASSIGN(const float yaw, angle(spawn.getYaw(), path + ".yaw"));
    spawns.push_back({feet, yaw, 0});
  }
  return {};
}

// Returns the ticks after which all moving and timed parts repeat; 0 if never, or more than 2^20.
uint32_t commonPeriod(const PartTables& t) {
  uint64_t period = 1;
  const auto include = [&](uint64_t ticks) {
    if (period != 0 && ticks != 0) period = std::lcm(period, ticks);
    if (period > (1u << 20)) period = 0;
  };
  for (const Mover& m : t.movers) {
    if (m.trigger != kNone) continue;
    if (m.once) return 0;
    include(m.keyCount);
    include(m.spinCount);
  }
  for (size_t i = 0; i < t.colliders.size(); ++i) {
    if (!(t.bounds[i].flags & kVanishTimer)) continue;
    const Roles& r = t.roles[t.colliders[i].role];
    include(r.vanishDelay + r.vanishAway);
  }
  return uint32_t(period);
}

// Digests the tables field by field, because structs have padding.
uint64_t digest(const LevelView& v, const PartTables& t) {
  uint64_t h = 1;
  const auto add = [&h](const auto& value) { h = hashBytes(&value, sizeof value, h); };
#define OBBY_PARAM_DIGEST(type, name) add(v.params.name);
  OBBY_FIRST_PARAMS(OBBY_PARAM_DIGEST)
#undef OBBY_PARAM_DIGEST
#define OBBY_PARAM_DIGEST(type, name) \
  if (v.params.name != 0) add(v.params.name);
  OBBY_LATER_PARAMS(OBBY_PARAM_DIGEST)
#undef OBBY_PARAM_DIGEST
  for (size_t i = 0; i < t.colliders.size(); ++i) {
    const Collider& c = t.colliders[i];
    add(c.pose), add(c.shape.half), add(c.part), add(c.mover), add(c.role), add(c.friction),
        add(c.grip), add(c.kind), add(t.bounds[i].flags);
    if (c.shape.hull)
      h = hashBytes(c.shape.hull->vertices, c.shape.hull->vertexCount * sizeof(Vec3), h);
  }
  for (const Roles& r : t.roles) {
    add(r.damage), add(r.cooldownTicks), add(r.padKeepsSideways), add(r.padVelocity),
        add(r.conveyorVelocity);
    add(r.conveyorAngular), add(r.vanishDelay), add(r.vanishAway), add(r.vanishPhase);
    add(r.vanishInverted), add(r.awayClock), add(r.awayFrom), add(r.starts), add(r.healClock);
    add(r.teleportTo), add(r.teleportYaw), add(r.teleportTurns), add(r.teleportKeepsVelocity);
    add(r.oneWay), add(r.seatClock);
  }
  for (const Clock& c : t.clocks) h = digestOf(c, h);
  for (const Mover& m : t.movers) {
    h = hashBytes(m.keys, m.keyCount * sizeof(Pose), h);
    h = hashBytes(m.spins, m.spinCount * sizeof(Mat3), h);
    add(m.pivot), add(m.once), add(m.trigger);
  }
  for (const DynamicBody& l : t.bodies)
    add(l.position), add(l.rotation), add(l.center), add(l.inverseInertia), add(l.inverseMass);
  if (t.bodies.empty()) return h;
  for (const Collider& c : t.colliders) add(c.elasticity);
  return h;
}

}  // namespace

Level::Level(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Level::Level(Level&&) noexcept = default;
Level& Level::operator=(Level&&) noexcept = default;
Level::~Level() = default;

Result<Level> Level::compile(schema::Level::Reader record) {
  auto impl = std::make_unique<Impl>();
  impl->name = record.getName();
  OBBY_ASSIGN(const Params params, compileParams(record.getPhysics()));
  OBBY_ASSIGN(impl->tables, compileParts(record, params));
  OBBY_RETURN_IF_ERROR(compileSpawns(record, impl->spawns));
  const PartTables& t = impl->tables;
  const float sideways = fastestSideways(t, params);
  const std::span<const Bounds> fixed{t.bounds.data(), t.fixedColliders};
  const uint32_t filler = uint32_t(t.colliders.size());
  impl->grid = buildGrid(fixed, filler, reachOf(params, sideways, fastestJump(t, params)));
  if (!t.bodies.empty()) impl->bodyGrid = buildGrid(fixed, filler, dynamicReach(t, params));
  LevelView& v = impl->view;
  v.params = params;
  v.colliders = t.colliders.data();
  v.bounds = t.bounds.data();
  v.roles = t.roles.data();
  v.movers = t.movers.data();
  v.bodies = t.bodies.data();
  v.clocks = t.clocks.data();
  v.clockCount = uint32_t(t.clocks.size());
  v.crushClock = t.crushClock;
  v.airClock = t.airClock;
  v.colliderCount = uint32_t(t.colliders.size());
  v.roleCount = uint32_t(t.roles.size());
  v.moverCount = uint32_t(t.movers.size());
  v.bodyCount = uint32_t(t.bodies.size());
  v.grid = gridOf(impl->grid);
  v.bodyGrid = gridOf(impl->bodyGrid);
  v.maxSideSpeed = sideways * kSpeedMargin;
  impl->period = commonPeriod(t);
  impl->hash = digest(v, t);
  return Level(std::move(impl));
}

const LevelView& Level::view() const { return impl_->view; }
const std::string& Level::name() const { return impl_->name; }
uint64_t Level::hash() const { return impl_->hash; }
bool Level::hasMotion() const { return impl_->tables.timed; }
uint32_t Level::motionPeriod() const { return impl_->tables.timed ? impl_->period : 0; }
size_t Level::partCount() const { return impl_->tables.names.size(); }
const std::string& Level::partName(uint32_t part) const { return impl_->tables.names[part]; }
const std::vector<StartPose>& Level::spawns() const { return impl_->spawns; }

Box Level::bounds() const {
  Box all{};
  for (size_t i = 0; i < impl_->tables.colliders.size(); ++i) {
    const Box box = impl_->tables.bounds[i].box();
    all = i == 0 ? box : join(all, box);
  }
  return all;
}

}  // namespace obby::level
