#include "sim/simulator.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "level/record_values.h"
#include "sim/rules.h"
#include "sim/tick.h"
#include "sim/wide_tick.h"

namespace obby::sim {

static_assert(int(Outcome::goal) == int(schema::Outcome::GOAL) &&
                  int(Outcome::timeout) == int(schema::Outcome::TIMEOUT),
              "the order of schema Outcome");
static_assert(int(geom::ShapeKind::hull) == int(schema::Shape::HULL), "the order of schema Shape");

World makeWorld(const level::LevelView& level, const level::StartPose& start) {
  World w{};
  w.position = start.feet;
  w.health = level.params.maxHealth;
  w.tick = start.tick;
  w.part = level::kNone;
  w.yaw = turnsFromRadians(start.yaw);
  w.floorlessTicks = 0xffff;
  w.state = State::freefall;  // stands after a tick where there is a floor; no jump out of thin air
  return w;
}

uint64_t stateHash(const World& world) {
  uint64_t h = 0;
#define OBBY_HASH_FIELD(type, name) h = hashBytes(&world.name, sizeof world.name, h);
  OBBY_WORLD_FIELDS(OBBY_HASH_FIELD)
#undef OBBY_HASH_FIELD
  return hashBytes(world.clocks, world.clockCount * sizeof(RunningClock), h);
}

Result<Plan> planFromRecord(schema::Trajectory::Reader record) {
  Plan plan;
  OBBY_ASSIGN(plan.start.feet, level::position(record.getPosition(), "position"));
  plan.start.tick = record.getStartTick();
  plan.yaw = record.getYawTurns();
  plan.start.yaw = radiansFromTurns(plan.yaw);
  uint64_t ticks = 0;
  for (const auto run : record.getActions()) {
    ticks += run.getTicks();
    if (ticks > kMaxReplayTicks) {
      return level::pathError(fmt::format("actions[{}].ticks", plan.actions.size()),
                              "longer than 4 hours of play");
    }
    plan.actions.push_back({{run.getHeading(), run.getWalk(), run.getJump()}, run.getTicks()});
  }
  return plan;
}

void advance(World& world, const level::LevelView& level, const level::QueryView* query,
             Action action) {
  if (world.outcome != Outcome::running) return;
  tick(world, level, action);
  if (query) applyRules(world, level, *query);
}

void advanceAll(const level::LevelView& level, const level::QueryView* query,
                std::span<World* const> worlds, const Action* actions) {
  tickAll(level, worlds.data(), actions, worlds.size());
  if (query == nullptr) return;
  for (World* w : worlds) applyRules(*w, level, *query);
}

std::vector<World> replay(const level::LevelView& level, const level::QueryView* query,
                          const Plan& plan) {
  std::vector<World> worlds{makeWorld(level, plan.start)};
  worlds.back().yaw = plan.yaw;
  for (const ActionRun& run : plan.actions) {
    for (uint32_t t = 0; t < run.ticks; ++t) {
      World next = worlds.back();
      if (next.outcome != Outcome::running) return worlds;
      advance(next, level, query, run.action);
      worlds.push_back(next);
    }
  }
  return worlds;
}

}  // namespace obby::sim
