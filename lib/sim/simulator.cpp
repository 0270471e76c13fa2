#include "sim/simulator.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "level/record_values.h"
#include "level/tricks.h"
#include "sim/rules.h"
#include "sim/tick.h"
#include "sim/wide_tick.h"

namespace obby::sim {

static_assert(int(Outcome::goal) == int(schema::Outcome::GOAL) &&
                  int(Outcome::forbidden) == int(schema::Outcome::FORBIDDEN),
              "the order of schema Outcome");
static_assert(int(State::climbing) == int(schema::PlayerState::CLIMBING) &&
                  int(State::fallingDown) == int(schema::PlayerState::FALLING_DOWN),
              "the order of schema PlayerState");
static_assert(int(geom::ShapeKind::hull) == int(schema::Shape::HULL), "the order of schema Shape");

World makeWorld(const level::LevelView& level, const level::StartPose& start) {
  World w{};
  w.position = start.feet;
  w.health = level.params.maxHealth;
  w.tick = start.tick;
  w.part = level::kNone;
  w.yaw = turnsFromRadians(start.yaw);
  w.floorlessSteps = 0xffff;
  w.state = State::freefall;  // the first tick senses the floor, so no jump in the air is possible
  if (level.bodyCount != 0) w.flags |= kBodyAwake;
  return w;
}

std::vector<RigidBody> makeBodies(const level::LevelView& level) {
  std::vector<RigidBody> bodies(level.bodyCount);
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    const level::DynamicBody& l = level.bodies[i];
    bodies[i].position = l.position + toMat3(l.rotation) * l.center;
    bodies[i].rotation = l.rotation;
  }
  return bodies;
}

namespace {

uint64_t hashProgress(const World& world, uint64_t h) {
  bool any = false;
#define OBBY_ANY_FIELD(type, name) any |= world.name != 0;
  OBBY_PROGRESS_FIELDS(OBBY_ANY_FIELD)
#undef OBBY_ANY_FIELD
  if (!any) return h;
#define OBBY_HASH_FIELD(type, name) h = hashBytes(&world.name, sizeof world.name, h);
  OBBY_PROGRESS_FIELDS(OBBY_HASH_FIELD)
#undef OBBY_HASH_FIELD
  return h;
}

}  // namespace

uint64_t stateHash(const World& world, std::span<const RigidBody> bodies) {
  uint64_t h = 0;
#define OBBY_HASH_FIELD(type, name) h = hashBytes(&world.name, sizeof world.name, h);
  OBBY_WORLD_FIELDS(OBBY_HASH_FIELD)
#undef OBBY_HASH_FIELD
  h = hashProgress(world, h);
  h = hashBytes(world.clocks, world.clockCount * sizeof(RunningClock), h);
  for (const RigidBody& body : bodies) h = hashBytes(&body, sizeof body, h);
  return h;
}

Result<Plan> planFromRecord(schema::Trajectory::Reader record) {
  Plan plan;
  OBBY_ASSIGN(plan.start.feet, level::position(record.getPosition(), "position"));
  plan.start.tick = record.getStartTick();
  plan.yaw = record.getYawTurns();
  plan.start.yaw = radiansFromTurns(plan.yaw);
  OBBY_ASSIGN(plan.tricks, level::tricksOf(record.getTricks(), "tricks"));
  uint64_t ticks = 0;
  for (const auto run : record.getActions()) {
    ticks += run.getTicks();
    if (ticks > kMaxReplayTicks) {
      return level::pathError(fmt::format("actions[{}].ticks", plan.actions.size()),
                              "the trajectory is longer than 4 hours of play");
    }
    plan.actions.push_back({{run.getHeading(), run.getWalk(), run.getJump()}, run.getTicks()});
  }
  return plan;
}

void writePlan(const Plan& plan, schema::Trajectory::Builder to) {
  level::set(to.initPosition(), plan.start.feet);
  to.setYawTurns(plan.yaw);
  to.setStartTick(plan.start.tick);
  level::setTricks(to, plan.tricks);
  auto runs = to.initActions(uint32_t(plan.actions.size()));
  for (uint32_t i = 0; i < runs.size(); ++i) {
    runs[i].setTicks(plan.actions[i].ticks);
    runs[i].setWalk(plan.actions[i].action.walk);
    runs[i].setHeading(plan.actions[i].action.heading);
    runs[i].setJump(plan.actions[i].action.jump);
  }
}

void advance(World& world, RigidBody* bodies, const level::LevelView& level,
             const level::QueryView* query, Action action) {
  if (world.outcome != Outcome::running) return;
  const Before before = beforeOf(world);
  tick(world, bodies, level, action);
  if (query) applyRules(world, before, bodies, level, *query);
}

void advanceAll(const level::LevelView& level, const level::QueryView* query,
                std::span<World* const> worlds, RigidBody* const* bodies, const Action* actions) {
  thread_local std::vector<Before> before;  // kept, so that a tick allocates no memory
  before.clear();
  if (query != nullptr) {
    for (const World* world : worlds) before.push_back(beforeOf(*world));
  }
  tickAll(level, worlds.data(), bodies, actions, worlds.size());
  for (size_t i = 0; i < before.size(); ++i) {
    applyRules(*worlds[i], before[i], bodies != nullptr ? bodies[i] : nullptr, level, *query);
  }
}

ReplayEnd replay(const level::LevelView& asBuilt, const level::QueryView* query, const Plan& plan,
                 const Visit& visit) {
  level::LevelView level = asBuilt;
  level.params.tricks = plan.tricks;
  ReplayEnd now{makeWorld(level, plan.start), startBodies(level)};
  now.world.yaw = plan.yaw;
  World before = now.world;
  bool goesOn = visit({0, before, now.world, now.bodies});
  for (const ActionRun& run : plan.actions) {
    for (uint32_t t = 0; t < run.ticks && goesOn; ++t) {
      if (now.world.outcome != Outcome::running) return now;
      before = now.world;
      advance(now.world, now.bodies.data(), level, query, run.action);
      goesOn = visit({++now.ticks, before, now.world, now.bodies});
    }
  }
  return now;
}

Replay replay(const level::LevelView& level, const level::QueryView* query, const Plan& plan) {
  Replay out;
  replay(level, query, plan, [&](const Moment& now) {
    out.worlds.push_back(now.world);
    out.bodies.insert(out.bodies.end(), now.bodies.begin(), now.bodies.end());
    return true;
  });
  return out;
}

}  // namespace obby::sim
