// The rules for reaching a solid part, and the contacts of the feet.
#include <gtest/gtest.h>

#include "sim/play.h"
#include "sim/targets.h"

namespace obby::test {
namespace {

using sim::State;

// Returns a level with a pad to reach. Its top is 10 studs up, and its near side is at z = -10.
level::Level withPad() {
  return support::LevelBuilder()
      .block({0, -1, 0}, {200, 2, 200})
      .block({0, 9.5f, -14}, {8, 1, 8})
      .compile();
}

// Returns a query whose goal is the pad, with this arrival rule.
level::Query queryOf(const level::Level& level, schema::Arrive arrive) {
  capnp::MallocMessageBuilder message;
  auto record = message.initRoot<schema::Query>();
  auto goal = record.initGoal();
  support::set(goal.initPosition(), {0, 9.75f, -14});
  support::set(goal.initSize(), {10, 1.5f, 10});
  goal.setPartIndex(1);
  record.setArrive(arrive);
  record.initStart().initRegion();
  return *level::Query::compile(record.asReader(), level);
}

bool reachesPad(const Play& play, const level::Query& query) {
  const level::QueryView q = query.view();
  return sim::reaches(play.world, nullptr, play.level.view(), q, q.goal);
}

TEST(Arrive, StandingOnThePartCounts) {
  const auto level = withPad();
  Play play(level, {0, 10.5f, -14});
  for (const auto arrive : {schema::Arrive::STAND, schema::Arrive::TOUCH}) {
    const level::Query q = queryOf(level, arrive);
    EXPECT_TRUE(reachesPad(play.settle(), q));
  }
}

TEST(Arrive, GrazingItsSideInAFallIsOnlyATouch) {
  const auto level = withPad();
  const level::Query stands = queryOf(level, schema::Arrive::STAND);
  const level::Query touches = queryOf(level, schema::Arrive::TOUCH);
  Play play(level, {0, 14, -9.3f});
  int stood = 0, touched = 0;
  for (int i = 0; i < 60; ++i) {
    play.run(stand());
    stood += reachesPad(play, stands);
    touched += reachesPad(play, touches);
  }
  EXPECT_EQ(stood, 0);
  EXPECT_GT(touched, 0);
}

TEST(Arrive, FlyingOverItIsNotStandingOnIt) {
  const auto level = withPad();
  const level::Query q = queryOf(level, schema::Arrive::STAND);
  Play play(level, {0, 10.4f, -14});
  EXPECT_FALSE(reachesPad(play, q)) << "still in Freefall";
}

TEST(Arrive, StandingAtItsFootIsNotStandingOnIt) {
  const auto level = support::LevelBuilder()
                         .block({0, -1, 0}, {200, 2, 200})
                         .block({0, 4, -14}, {8, 8, 8})
                         .compile();
  capnp::MallocMessageBuilder message;
  auto record = message.initRoot<schema::Query>();
  support::set(record.initGoal().initPosition(), {0, 4.25f, -14});
  support::set(record.getGoal().initSize(), {10, 8.5f, 10});
  record.getGoal().setPartIndex(1);
  record.initStart().initRegion();
  const level::Query q = *level::Query::compile(record.asReader(), level);
  Play foot(level, {0, 0, -9.2f}), top(level, {0, 8, -14});
  EXPECT_FALSE(reachesPad(foot.settle(), q));
  EXPECT_TRUE(reachesPad(top.settle(), q));
}

// The box of the limbs ends slightly above the floor, but a player who stands on a floor touches
// it.
TEST(Feet, TouchTheFloorThatHoldsThem) {
  const auto kill = [](schema::Part::Builder p) { p.initKill(); };
  const auto level = support::LevelBuilder().block({0, -1, 0}, {20, 2, 20}, kill).compile();
  level::LevelView view = level.view();
  sim::World w = sim::makeWorld(view, {{0, 0.2f, 0}, 0, 0});
  w.state = State::running;
  w.flags |= sim::kFloorSensed;
  w.velocity.y = 0;
  sim::advance(w, nullptr, view, nullptr, stand());
  EXPECT_EQ(w.outcome, sim::Outcome::killed);
}

}  // namespace
}  // namespace obby::test
