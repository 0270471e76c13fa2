// Motion tables: easing end points, repeats, periods that do not drift, spins about pivots.
#include "level/motion_tables.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/level_builder.h"

namespace obby::level {
namespace {

using schema::Easing;
using schema::EasingDirection;
using schema::Repeat;
using MotionSetter = std::function<void(schema::Motion::Builder)>;

constexpr double kTwoPi = 6.283185307179586;
constexpr EasingDirection kDirections[] = {EasingDirection::IN, EasingDirection::OUT,
                                           EasingDirection::IN_OUT};

// The tables of one mover.
struct Tables {
  std::vector<Pose> keys;
  std::vector<Mat3> spins;
  Vec3 pivot;
  bool once;
};

Tables tablesOf(const MotionSetter& setter, uint32_t maxRows = kMaxRows) {
  capnp::MallocMessageBuilder message, physics;
  auto motion = message.initRoot<schema::Motion>();
  setter(motion);
  const Params params = *compileParams(physics.initRoot<schema::PhysicsParams>().asReader());
  const auto plan = planMotion(motion.asReader(), params, maxRows);
  EXPECT_TRUE(bool(plan)) << (plan ? "" : plan.error().text());
  return {keyTable(*plan, {{1, 2, 3}, {}}), spinTable(plan->spin), plan->pivot, plan->once};
}

// Sets a motion from x = 0 at time 0 to x = 10 at `seconds`.
MotionSetter slide(float seconds, Repeat repeat, float offset = 0, Easing easing = Easing::LINEAR) {
  return [=](schema::Motion::Builder m) {
    auto keys = m.initKeys(2);
    keys[1].setTime(seconds);
    keys[1].setEasing(easing);
    support::set(keys[1].initPosition(), {10, 0, 0});
    m.setRepeat(repeat);
    m.setOffset(offset);
  };
}

MotionSetter motionSpin(Vec3 axis, float speed, Vec3 pivot = {}, float offset = 0) {
  return [=](schema::Motion::Builder m) {
    auto s = m.initSpin();
    support::set(s.initAxis(), axis);
    s.setSpeed(speed);
    support::set(s.initPivot(), pivot);
    m.setOffset(offset);
  };
}

Mover moverOf(const Tables& t) {
  return {t.keys.data(),
          t.spins.empty() ? nullptr : t.spins.data(),
          uint32_t(t.keys.size()),
          uint32_t(t.spins.size()),
          t.pivot,
          t.once};
}

float xAt(const Tables& t, uint32_t tick) { return moverPose(moverOf(t), tick).position.x; }

TEST(Ease, StartsAt0AndEndsAt1ForEveryCurve) {
  for (int e = 0; e <= int(Easing::CUBIC); ++e) {
    for (const EasingDirection d : kDirections) {
      EXPECT_NEAR(ease(Easing(e), d, 0), 0, 1.1e-3) << e;  // exponential starts at 2^-10
      EXPECT_NEAR(ease(Easing(e), d, 1), 1, 1.1e-3) << e;
    }
  }
}

TEST(Ease, InAndOutMirrorOneAnotherAndInOutIsSymmetric) {
  for (int e = 0; e <= int(Easing::CUBIC); ++e) {
    for (double t = 0; t <= 1; t += 0.01) {
      EXPECT_NEAR(ease(Easing(e), EasingDirection::IN, t),
                  1 - ease(Easing(e), EasingDirection::OUT, 1 - t), 2e-7);
      if (std::fabs(t - 0.5) < 1e-9) continue;
      EXPECT_NEAR(ease(Easing(e), EasingDirection::IN_OUT, t),
                  1 - ease(Easing(e), EasingDirection::IN_OUT, 1 - t), 2e-7);
    }
  }
}

TEST(Ease, FollowsPennersCurves) {
  const auto in = [](Easing e, double t) { return ease(e, EasingDirection::IN, t); };
  EXPECT_NEAR(in(Easing::LINEAR, 0.3), 0.3, 1e-7);
  EXPECT_NEAR(in(Easing::SINE, 0.5), 1 - std::sqrt(0.5), 1e-7);
  EXPECT_NEAR(in(Easing::QUAD, 0.3), 0.09, 1e-7);
  EXPECT_NEAR(in(Easing::CUBIC, 0.3), 0.027, 1e-7);
  EXPECT_NEAR(in(Easing::QUART, 0.3), 0.0081, 1e-7);
  EXPECT_NEAR(in(Easing::QUINT, 0.3), 0.00243, 1e-7);
  EXPECT_NEAR(in(Easing::CIRCULAR, 0.6), 0.2, 1e-7);
  EXPECT_NEAR(in(Easing::EXPONENTIAL, 0.5), 1.0 / 32, 1e-7);
  EXPECT_LT(in(Easing::BACK, 0.3), 0);
  EXPECT_LT(in(Easing::ELASTIC, 0.85), 0);
  EXPECT_NEAR(ease(Easing::BOUNCE, EasingDirection::OUT, 1 / 2.75), 1, 1e-6);
}

TEST(Motion, LinearKeysMoveEvenlyAndLoopJumpsBack) {
  const Tables t = tablesOf(slide(2, Repeat::LOOP));
  ASSERT_EQ(t.keys.size(), 120u);
  for (uint32_t tick = 0; tick < 360; ++tick) {
    EXPECT_NEAR(xAt(t, tick), 10.0f * float(tick % 120) / 120, 1e-4f) << tick;
  }
}

TEST(Motion, PingPongReturnsAlongItsPath) {
  const Tables t = tablesOf(slide(2, Repeat::PING_PONG, 0, Easing::QUAD));
  ASSERT_EQ(t.keys.size(), 240u);
  EXPECT_NEAR(xAt(t, 120), 10, 1e-4f);
  for (uint32_t tick = 1; tick < 120; ++tick) EXPECT_NEAR(xAt(t, tick), xAt(t, 240 - tick), 1e-4f);
}

TEST(Motion, OnceStaysAtTheLastKey) {
  const Tables t = tablesOf(slide(2, Repeat::ONCE));
  EXPECT_EQ(xAt(t, 0), 0);
  EXPECT_NEAR(xAt(t, 60), 5, 1e-4f);
  for (const uint32_t tick : {120u, 121u, 1000u, 4000000000u}) EXPECT_EQ(xAt(t, tick), 10);
}

TEST(Motion, OffsetIsTimeAlreadyElapsed) {
  EXPECT_NEAR(xAt(tablesOf(slide(2, Repeat::LOOP, 0.5f)), 0), 2.5f, 1e-4f);
  EXPECT_NEAR(xAt(tablesOf(slide(2, Repeat::LOOP, -0.5f)), 0), 7.5f, 1e-4f);
  EXPECT_NEAR(xAt(tablesOf(slide(2, Repeat::PING_PONG, 2.5f)), 0), 7.5f, 1e-4f);
  EXPECT_EQ(xAt(tablesOf(slide(2, Repeat::ONCE, 5)), 0), 10);
}

// A script that waits before a repeating motion imports as a negative offset. After the wait, the
// part is at its first key.
TEST(Motion, RepeatsAreAtTheirStartAfterANegativeOffset) {
  for (const float wait : {0.5f, 1.0f, 7.25f, 599.5f}) {
    const auto end = uint32_t(60 * wait);
    for (const Repeat repeat : {Repeat::LOOP, Repeat::PING_PONG}) {
      const Tables t = tablesOf(slide(2, repeat, -wait));
      EXPECT_NEAR(xAt(t, end + 6), 0.5f, 1e-3f) << wait;
      EXPECT_NEAR(xAt(t, end + 60), 5, 1e-3f) << wait;
    }
    const Tables t = tablesOf(motionSpin({0, 1, 0}, float(kTwoPi / 4), {}, -wait));
    EXPECT_NEAR((moverPose(moverOf(t), end).rotation * Vec3{0, 0, -1}).z, -1, 1e-4f) << wait;
    EXPECT_NEAR((moverPose(moverOf(t), end + 60).rotation * Vec3{0, 0, -1}).x, -1, 1e-4f) << wait;
  }
}

TEST(Motion, OnceWithANegativeOffsetWaitsAndStillArrives) {
  const Tables t = tablesOf(slide(2, Repeat::ONCE, -5));
  EXPECT_EQ(xAt(t, 0), 0);
  EXPECT_EQ(xAt(t, 300), 0);
  EXPECT_NEAR(xAt(t, 360), 5, 1e-3f);
  EXPECT_EQ(xAt(t, 430), 10);
}

// Returns the error of the table's period after 10 minutes, in ticks.
double driftInTicks(double periodTicks, const Tables& t) {
  const double tick = 36000;
  const double repetitions = std::max(1.0, std::round(double(t.keys.size()) / periodTicks));
  return tick * std::fabs(double(t.keys.size()) / repetitions / periodTicks - 1);
}

TEST(Motion, PeriodsOfWholeCentisecondsDriftLessThanAHundredthTickInTenMinutes) {
  for (const float seconds :
       {0.05f, 0.1f, 0.25f, 0.33f, 0.7f, 1.23f, 2.71f, 3.14f, 9.99f, 59.99f}) {
    const double ticks = double(seconds) * 60;
    EXPECT_LT(driftInTicks(ticks, tablesOf(slide(seconds, Repeat::LOOP))), 0.01) << seconds;
  }
}

TEST(Motion, AnyPeriodIsExactToATwoHundredthTickInBoundedTables) {
  Random random(40, 0);
  for (int i = 0; i < 200; ++i) {
    const float seconds = 0.2f + 20 * random.unit();
    const Tables t = tablesOf(slide(seconds, Repeat::LOOP));
    ASSERT_LE(t.keys.size(), kMaxRows);
    const double ticks = double(seconds) * 60, rows = double(t.keys.size());
    EXPECT_LT(std::fabs(rows / std::round(rows / ticks) - ticks), 0.005) << seconds;
  }
}

// A table that would have too many rows holds fewer periods.
TEST(Motion, ShorterTablesHoldAsManyPeriodsAsFit) {
  Random random(41, 0);
  constexpr uint32_t kFew = 1000;
  for (int i = 0; i < 200; ++i) {
    const float seconds = 0.2f + 40 * random.unit();
    const double ticks = double(seconds) * 60;
    const Tables t = tablesOf(slide(seconds, Repeat::LOOP), kFew);
    const double rows = double(t.keys.size());
    ASSERT_LE(rows, std::max(double(kFew), ticks + 0.5)) << seconds;
    EXPECT_LE(std::fabs(rows / std::round(rows / ticks) - ticks), 0.5) << seconds;
    if (ticks < kFew / 10) {
      EXPECT_LE(std::fabs(rows / std::round(rows / ticks) - ticks), 0.05) << seconds;
    }
  }
  const Tables turning = tablesOf(motionSpin({0, 1, 0}, 0.1f), kFew);
  EXPECT_EQ(turning.spins.size(), 3770u) << "one turn takes 3769.9 ticks";
  EXPECT_GT(tablesOf(motionSpin({0, 1, 0}, 0.1f)).spins.size(), 3770u);
}

TEST(Motion, SpinTurnsRightHandedAtItsSpeed) {
  const Tables t = tablesOf(motionSpin({0, 2, 0}, float(kTwoPi / 4)));  // a quarter turn a second
  ASSERT_EQ(t.spins.size(), 240u);
  const Vec3 ahead = moverPose(moverOf(t), 60).rotation * Vec3{0, 0, -1};
  EXPECT_NEAR(ahead.x, -1, 1e-5f);
  EXPECT_NEAR((moverPose(moverOf(t), 240).rotation * Vec3{0, 0, -1}).z, -1, 1e-5f);
  const Tables back = tablesOf(motionSpin({0, 1, 0}, float(-kTwoPi / 4)));
  EXPECT_NEAR((moverPose(moverOf(back), 60).rotation * Vec3{0, 0, -1}).x, 1, 1e-5f);
  const Tables ahead1 = tablesOf(motionSpin({0, 1, 0}, float(kTwoPi / 4), {}, 1));
  EXPECT_NEAR((moverPose(moverOf(ahead1), 0).rotation * Vec3{0, 0, -1}).x, -1, 1e-5f);
}

TEST(Motion, SpinAxesMayHaveAnyLength) {
  for (const float length : {1e-5f, 1e15f, 3e30f, 3e38f}) {
    const Tables t = tablesOf(motionSpin({0, length, 0}, float(kTwoPi / 4)));
    EXPECT_NEAR((moverPose(moverOf(t), 60).rotation * Vec3{0, 0, -1}).x, -1, 1e-5f) << length;
  }
}

TEST(Motion, SpinKeepsThePivotInPlace) {
  const Vec3 pivot{3, 1, -2};
  const Tables t = tablesOf(motionSpin({1, 1, 0.5f}, 2.2f, pivot));
  const Vec3 at = toWorld(Pose{{1, 2, 3}, {}}, pivot);
  for (uint32_t tick = 0; tick < 2000; tick += 7) {
    const Pose pose = moverPose(moverOf(t), tick);
    ASSERT_LT(length(toWorld(pose, pivot) - at), 1e-5f);
    ASSERT_NEAR(length(pose.position - at), length(pivot), 1e-4f);
  }
}

TEST(Motion, RestsWithoutKeysOrSpin) {
  const Tables t = tablesOf([](auto) {});
  ASSERT_EQ(t.keys.size(), 1u);
  EXPECT_TRUE(t.keys[0].position == (Vec3{1, 2, 3}));
  EXPECT_TRUE(t.spins.empty());
}

TEST(Motion, KeysAtTheSameTimeJump) {
  const Tables t = tablesOf([](schema::Motion::Builder m) {
    auto keys = m.initKeys(4);
    const float times[] = {0, 1, 1, 2}, xs[] = {0, 0, 5, 5};
    for (uint32_t i = 0; i < 4; ++i) {
      keys[i].setTime(times[i]);
      support::set(keys[i].initPosition(), {xs[i], 0, 0});
    }
  });
  EXPECT_EQ(xAt(t, 59), 0);
  EXPECT_EQ(xAt(t, 61), 5);
}

TEST(Motion, RotationsTakeTheShorterArc) {
  const Tables t = tablesOf([](schema::Motion::Builder m) {
    auto keys = m.initKeys(2);
    keys[1].setTime(1);
    auto q = keys[1].initRotation();  // a quarter turn about Y, as the negative quaternion
    q.setY(-float(std::sqrt(0.5)));
    q.setW(-float(std::sqrt(0.5)));
  });
  const Vec3 half = moverPose(moverOf(t), 30).rotation * Vec3{0, 0, -1};
  EXPECT_NEAR(half.x, -std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(half.z, -std::sqrt(0.5), 1e-5);
}

TEST(MotionPeriod, IsTheLeastCommonPeriodOfEverythingTimed) {
  const auto add = [](support::LevelBuilder& b, const MotionSetter& m) {
    b.block({0, 0, 0}, {1, 1, 1}, [=](auto p) { m(p.initMotion()); });
  };
  support::LevelBuilder b;
  EXPECT_EQ(b.block({0, 0, 0}, {1, 1, 1}).compile().motionPeriod(), 0u);
  add(b, slide(2, Repeat::LOOP));
  EXPECT_EQ(b.compile().motionPeriod(), 120u);
  add(b, slide(0.75f, Repeat::PING_PONG));
  EXPECT_EQ(b.compile().motionPeriod(), 360u);
  b.block({0, 0, 0}, {1, 1, 1}, [](auto p) {
    auto v = p.initVanish();
    v.setTrigger(schema::VanishTrigger::TIMER);
    v.setDelay(0.35f);
    v.setAway(0.35f);
  });
  EXPECT_EQ(b.compile().motionPeriod(), 2520u);
  add(b, slide(1, Repeat::ONCE));
  EXPECT_EQ(b.compile().motionPeriod(), 0u);
  EXPECT_TRUE(b.compile().hasMotion());
}

}  // namespace
}  // namespace obby::level
