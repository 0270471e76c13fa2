// Effects that touches start: buttons and the parts that respond, boosts, heals, and the limit on
// clocks that run at once.
#include <gtest/gtest.h>

#include "sim/clocks.h"
#include "sim/play.h"

namespace obby::test {
namespace {

using schema::Part;
using sim::World;
using support::LevelBuilder;

// Adds a plate at z = -6 that is a button.
LevelBuilder& withButton(LevelBuilder& b, float seconds, bool restarts = false) {
  return b.block({0, 0.1f, -6}, {4, 0.2f, 2}, [=](Part::Builder p) {
    auto button = p.initButton();
    button.setSignal("door");
    button.setSeconds(seconds);
    button.setRestarts(restarts);
  });
}

void respond(Part::Builder p, float delay = 0, bool inverted = false) {
  auto vanish = p.initVanish();
  vanish.setTrigger(schema::VanishTrigger::SIGNAL);
  vanish.setSignal("door");
  vanish.setDelay(delay);
  vanish.setInverted(inverted);
}

// Returns a level with a wall across the course at z = -20. The button opens the wall.
LevelBuilder doorLevel(float seconds) {
  LevelBuilder b = floorLevel();
  withButton(b, seconds);
  b.block({0, 10, -20}, {200, 20, 1}, [](Part::Builder p) { respond(p); });
  return b;
}

TEST(Button, OpensADoorForItsTime) {
  const auto level = doorLevel(3).compile();
  Play play(level);
  play.settle().run(walk(kNorth), 150);
  EXPECT_LT(play.world.position.z, -22) << "through";
  const auto brief = doorLevel(0.3f).compile();
  Play late(brief);
  late.settle().run(walk(kNorth), 150);
  EXPECT_GT(late.world.position.z, -20) << "closed again before the player came";
}

TEST(Button, LeavesTheDoorClosedUntilItIsTouched) {
  const auto level = doorLevel(3).compile();
  Play play(level, {20, 0, 0});  // the player passes next to the button
  play.settle().run(walk(kNorth), 200);
  EXPECT_GT(play.world.position.z, -20);
  EXPECT_EQ(play.world.clockCount, 0);
}

TEST(Button, ClosesAnInvertedPartForItsTime) {
  LevelBuilder b = floorLevel();
  withButton(b, 2);
  b.block({0, 10, -20}, {200, 20, 1}, [](Part::Builder p) { respond(p, 0, true); });
  const auto level = b.compile();
  Play pressed(level);
  pressed.settle().run(walk(kNorth), 120);
  EXPECT_GT(pressed.world.position.z, -20) << "solid while the signal lasts";
  Play unpressed(level, {20, 0, 0});
  unpressed.settle().run(walk(kNorth), 120);
  EXPECT_LT(unpressed.world.position.z, -22) << "away otherwise";
}

TEST(Button, CountsFromTheFirstOrTheLastTouch) {
  const auto ticksOpen = [](bool restarts) {
    LevelBuilder b = floorLevel();
    withButton(b, 1, restarts);
    b.block({0, 10, -40}, {4, 20, 1}, [](Part::Builder p) { respond(p); });
    const auto level = b.compile();
    Play play(level, {0, 1, -6});
    play.run(stand(), 90);  // stands on the button
    return play.world.clocks[0].ticks;
  };
  EXPECT_GT(ticksOpen(false), 10u) << "a second signal after the first";
  EXPECT_EQ(ticksOpen(true), 0u);
}

TEST(Button, ADelayKeepsTheDoorShutAtFirst) {
  LevelBuilder b = floorLevel();
  withButton(b, 5);
  b.block({0, 10, -8.5f}, {200, 20, 1}, [](Part::Builder p) { respond(p, 1.5f); });
  const auto level = b.compile();
  Play play(level);
  play.settle().run(walk(kNorth), 80);
  EXPECT_GT(play.world.position.z, -9);
  play.run(walk(kNorth), 60);
  EXPECT_LT(play.world.position.z, -9);
}

LevelBuilder boostLevel(const std::function<void(schema::Boost::Builder)>& setter) {
  return floorLevel().block({0, 0.1f, -6}, {4, 0.2f, 4},
                            [=](Part::Builder p) { setter(p.initBoost()); });
}

TEST(Boost, MakesThePlayerFasterForItsSeconds) {
  const auto level = boostLevel([](auto b) { b.setWalkSpeed(2), b.setSeconds(1.5f); }).compile();
  Play play(level);
  play.settle().run(walk(kNorth), 60);
  EXPECT_NEAR(-play.world.velocity.z, 32, 0.5f);
  play.run(walk(kNorth), 120);
  EXPECT_NEAR(-play.world.velocity.z, 16, 0.5f);
}

TEST(Boost, LastsWhileThePartIsTouchedWithoutSeconds) {
  const auto level = boostLevel([](auto b) { b.setJumpSpeed(1.5f); }).compile();
  Play on(level, {0, 0.2f, -6});
  on.settle().run(stand(true)).run(stand(), 40);
  EXPECT_NEAR(on.highest() - 0.2f, 79.5f * 79.5f / (2 * 196.2f), 0.5f);
  Play off(level, {20, 0, -6});
  off.settle().run(stand(true)).run(stand(), 40);
  EXPECT_NEAR(off.highest(), 53 * 53 / (2 * 196.2f), 0.3f);
}

TEST(Boost, ForeverLastsAndTheLastTouchedCounts) {
  LevelBuilder b = boostLevel([](auto boost) { boost.setWalkSpeed(2), boost.setForever(true); });
  b.block({0, 0.1f, -30}, {4, 0.2f, 4}, [](Part::Builder p) {
    p.initBoost().setWalkSpeed(0.5f);
    p.getBoost().setForever(true);
  });
  const auto level = b.compile();
  Play play(level);
  play.settle();
  play.until(walk(kNorth), [](const World& w) { return w.position.z < -24; });
  EXPECT_NEAR(-play.world.velocity.z, 32, 0.5f);
  play.run(walk(kNorth), 600);
  EXPECT_NEAR(-play.world.velocity.z, 8, 0.5f);
  EXPECT_EQ(play.world.clockCount, 2);
}

TEST(Boost, EqualBoostsShareAClock) {
  LevelBuilder b = floorLevel();
  for (int i = 0; i < 12; ++i) {
    b.block({0, 0.1f, -6 - 4 * float(i)}, {4, 0.2f, 2}, [](Part::Builder p) {
      p.initBoost().setWalkSpeed(2);
      p.getBoost().setSeconds(20);
    });
  }
  const auto level = b.compile();
  Play play(level);
  play.settle().run(walk(kNorth), 150);
  EXPECT_EQ(play.world.clockCount, 1);
  EXPECT_EQ(play.world.flags & sim::kOverruns, 0);
}

TEST(Heal, GivesHealthBackUpToTheFullAndOnceACooldown) {
  const auto healed = [](float damage, float cooldown, int ticks) {
    const auto level = LevelBuilder()
                           .block({0, -1, 0}, {20, 2, 20},
                                  [=](Part::Builder p) {
                                    p.initKill().setDamage(damage);
                                    p.getKill().setCooldown(cooldown);
                                  })
                           .physics([](auto p) { p.setHealthRegeneration(0); })
                           .compile();
    Play play(level);
    play.world.health = 30;
    play.run(stand(), ticks);
    return play.world.health;
  };
  EXPECT_EQ(healed(-10, 1, 30), 40);
  EXPECT_EQ(healed(-10, 1, 90), 50);
  EXPECT_EQ(healed(-10, 0, 90), 100);
}

TEST(Clocks, ReportsAndIgnoresClocksBeyondTheLimit) {
  LevelBuilder b;
  for (int i = 0; i < 10; ++i) {
    b.block({0.2f * float(i) - 1, -1, 0}, {0.2f, 2, 8},
            [](Part::Builder p) { p.initVanish().setDelay(5); });
  }
  const auto level = b.compile();
  Play play(level);
  play.run(stand(), 30);
  EXPECT_EQ(play.world.clockCount, sim::kMaxClocks);
  EXPECT_NE(play.world.flags & sim::kClockOverrun, 0);
}

}  // namespace
}  // namespace obby::test
