#include "solve/search/archive/cell.h"

#include <gtest/gtest.h>

#include <set>

#include "scenes.h"
#include "solve/search/archive/binning.h"

namespace obby::solve {
namespace {

sim::World worldAt(Vec3 position) {
  sim::World w{};
  w.position = position;
  w.health = 100;
  return w;
}

TEST(Cell, FloorIsTowardMinusInfinity) {
  EXPECT_EQ(floorToInt(1.5f), 1);
  EXPECT_EQ(floorToInt(-0.25f), -1);
  EXPECT_EQ(floorToInt(-2.0f), -2);
}

TEST(Cell, PositionsOfOneCellShareAKeyAndNeighboursDoNot) {
  const Binning b;
  EXPECT_EQ(cellKey(b, worldAt({0.1f, 0.1f, 0.1f})), cellKey(b, worldAt({0.9f, 1.9f, 0.9f})));
  std::set<uint64_t> keys;
  for (int x = -5; x < 5; ++x) {
    for (int y = -5; y < 5; ++y) {
      for (int z = -5; z < 5; ++z) {
        keys.insert(cellKey(b, worldAt({float(x) + 0.5f, 2 * float(y) + 1, float(z) + 0.5f})));
      }
    }
  }
  EXPECT_EQ(keys.size(), 1000u);
  EXPECT_EQ(keys.count(0), 0u);
}

TEST(Cell, DimensionsCountOnlyIfTheProblemNeedsThem) {
  sim::World a = worldAt({1, 1, 1}), b = a;
  b.tick = 500;
  b.jumps = 3;
  b.waypoints = 1;
  b.clockCount = 1;
  b.health = 30;
  EXPECT_EQ(cellKey(Binning{}, a), cellKey(Binning{}, b));
  Binning jumps, waypoints, clocks, health, clock;
  jumps.jumps = waypoints.waypoints = clocks.clocks = true;
  health.healthBins = 4;
  clock.clockBin = 30;
  const uint32_t always = 0;
  clock.clock = {&always, {0, 0, 0}, 0.1f, 1, 1, 1};
  clocks.clock.bins = &always;  // this clock does not distinguish states; it is only counted
  for (const Binning& binning : {jumps, waypoints, clocks, health, clock}) {
    EXPECT_NE(cellKey(binning, a), cellKey(binning, b));
  }
}

// Returns the stepping stones, and a block at x = 50 that moves up and down once in 4 seconds.
LevelBuilder stonesAndLift() {
  return steppingStones().block({50, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) {
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    support::set(keys[0].initPosition(), {50, 0, 0});
    support::set(keys[1].initPosition(), {50, 20, 0});
    keys[1].setTime(2);
  });
}

TEST(Cell, NearMovingPartsTheClockCountsModuloTheirPeriod) {
  const level::Level level = stonesAndLift().compile();
  const ClockMap clock(level.view(), 10);
  const Binning b = makeBinning(PlainQuery(level).problem(), 1, clock);
  sim::World early = worldAt({48, 1, 0}), later = early, other = early;
  early.tick = 10;
  later.tick = 10 + 240 * 7;
  other.tick = 10 + 120;
  EXPECT_EQ(cellKey(b, early), cellKey(b, later));
  EXPECT_NE(cellKey(b, early), cellKey(b, other));
  early.position = other.position = {0, 1, 0};
  EXPECT_EQ(cellKey(b, early), cellKey(b, other));
}

TEST(ClockMap, JoinsThePeriodsOfPartsThatAreNearEachOther) {
  EXPECT_EQ(jointPeriod(60, 90), 180u);
  EXPECT_EQ(jointPeriod(kNoClock, 90), 90u);
  EXPECT_EQ(jointPeriod(3599, 3600), 0u);
  EXPECT_EQ(jointPeriod(0, 60), 0u);
  const level::Level level = stonesAndLift()
                                 .block({60, 0, 0}, {4, 1, 4},
                                        [](schema::Part::Builder p) {
                                          auto v = p.initVanish();
                                          v.setTrigger(schema::VanishTrigger::TIMER);
                                          v.setDelay(1);
                                          v.setAway(0.5f);
                                        })
                                 .compile();
  const ClockMap clock(level.view(), 4);
  EXPECT_EQ(clockPeriodAt(clock.view(), {49, 10, 0}), 240u);
  EXPECT_EQ(clockPeriodAt(clock.view(), {61, 0, 0}) % 90, 0u);
  EXPECT_EQ(clockPeriodAt(clock.view(), {0, 0, 0}), kNoClock);
  EXPECT_EQ(clockPeriodAt(clock.view(), {1e9f, 0, 0}), kNoClock);
}

TEST(Binning, FollowsTheQueryAndTheLevel) {
  const level::Level stones = steppingStones().compile();
  const ClockMap clock(stones.view(), 10);
  PlainQuery q(stones);
  const Binning plain = makeBinning(q.problem(), 1, clock);
  EXPECT_FALSE(plain.jumps || plain.waypoints || plain.clocks);
  EXPECT_EQ(plain.clockBin, 0u);
  EXPECT_EQ(plain.healthBins, 0u);
  q.query.maxJumps = 2;
  q.waypoints.push_back({boxAt({0, 2, -16}, {8, 4, 8}), -1});
  const Binning limited = makeBinning(q.problem(), 1, clock);
  EXPECT_TRUE(limited.jumps && limited.waypoints);
}

TEST(Binning, MotionAndVanishingAndDamageAddDimensions) {
  const level::Level level =
      steppingStones()
          .block({20, 0, 0}, {4, 1, 4},
                 [](schema::Part::Builder p) { p.initMotion().initSpin().setSpeed(1); })
          .block({30, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) { p.initVanish(); })
          .block({40, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) { p.initKill().setDamage(40); })
          .compile();
  const ClockMap clock(level.view(), 10);
  PlainQuery q(level);
  const Binning b = makeBinning(q.problem(), 1, clock);
  EXPECT_GT(b.clockBin, 0u);
  EXPECT_TRUE(b.clocks);
  EXPECT_GT(b.healthBins, 0u);
}

// For a signal, the remaining time distinguishes states. For a part that vanishes by itself, only
// whether its clock runs does.
TEST(Cell, RunningSignalsDistinguishStates) {
  const level::Level level =
      steppingStones()
          .block({20, 0, 0}, {4, 1, 4},
                 [](schema::Part::Builder p) { p.initButton().setSignal("a"); })
          .block({30, 0, 0}, {4, 1, 4},
                 [](schema::Part::Builder p) { p.initButton().setSignal("b"); })
          .block({40, 0, 0}, {4, 1, 4},
                 [](schema::Part::Builder p) {
                   p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
                   p.getVanish().setSignal("a");
                 })
          .block({50, 0, 0}, {4, 1, 4},
                 [](schema::Part::Builder p) {
                   p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
                   p.getVanish().setSignal("b");
                 })
          .block({60, 0, 0}, {4, 1, 4}, [](schema::Part::Builder p) { p.initVanish(); })
          .compile();
  const ClockMap clock(level.view(), 10);
  const Binning b = makeBinning(PlainQuery(level).problem(), 1, clock);
  const uint32_t count = level.view().clockCount, signalA = count - 2, signalB = count - 1;
  const auto key = [&](uint32_t running, uint32_t ticks) {
    sim::World w = worldAt({0, 1, 0});
    w.clocks[w.clockCount++] = {running, ticks};
    return cellKey(b, w);
  };
  EXPECT_NE(key(signalA, 0), key(signalB, 0));
  EXPECT_EQ(key(signalA, 0), key(signalA, 20));
  EXPECT_NE(key(signalA, 0), key(signalA, 200));
  const uint32_t vanishing = signalA - 1;  // the last clock of a role; clocks of signals follow
  EXPECT_EQ(key(vanishing, 0), key(vanishing, 200));
  EXPECT_NE(key(vanishing, 0), cellKey(b, worldAt({0, 1, 0})));
}

TEST(Binning, AFasterPlayerHasWiderCells) {
  auto fast = steppingStones();
  fast.physics([](schema::PhysicsParams::Builder p) { p.setWalkSpeed(32); });
  const level::Level level = fast.compile();
  const ClockMap clock(level.view(), 10);
  EXPECT_FLOAT_EQ(makeBinning(PlainQuery(level).problem(), 1, clock).inverseWidth, 0.5f);
}

}  // namespace
}  // namespace obby::solve
