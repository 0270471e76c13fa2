// Errors of meaningless levels state the field's path and the expected value.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/level_builder.h"

namespace obby::level {
namespace {

using support::LevelBuilder;
using support::set;
using PartSetter = LevelBuilder::PartSetter;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// Compiles a valid part before the part under test, so that the part's index is 1.
void expectRefused(const PartSetter& setter, const std::string& path, const std::string& words) {
  LevelBuilder b;
  b.block({0, 0, 0}, {4, 1, 4}).part(setter);
  const auto level = b.tryCompile();
  ASSERT_FALSE(bool(level)) << path;
  EXPECT_EQ(level.error().path, "parts[1]" + path);
  EXPECT_NE(level.error().message.find(words), std::string::npos) << level.error().text();
}

void addKeys(schema::Part::Builder part, std::initializer_list<float> times) {
  auto keys = part.initMotion().initKeys(uint32_t(times.size()));
  uint32_t i = 0;
  for (const float t : times) keys[i++].setTime(t);
}

TEST(CompileErrors, Size) {
  for (const Vec3 size :
       {Vec3{0, 1, 1}, Vec3{1, -1, 1}, Vec3{1, 1, 2049}, Vec3{kNan, 1, 1}, Vec3{1, kInf, 1}}) {
    expectRefused([=](auto p) { set(p.initSize(), size); }, ".size", "above 0 and at most 2048");
  }
}

TEST(CompileErrors, Position) {
  for (const Vec3 at : {Vec3{kNan, 0, 0}, Vec3{0, kInf, 0}, Vec3{0, 0, -2e6f}}) {
    expectRefused([=](auto p) { set(p.initPosition(), at); }, ".position",
                  "from -1000000 to 1000000");
  }
}

TEST(CompileErrors, Rotation) {
  for (const float w : {0.0f, kNan, kInf, 1e-8f}) {
    expectRefused([=](auto p) { p.initRotation().setW(w); }, ".rotation", "0.001 to 1000");
  }
  expectRefused([](auto p) { p.initRotation().setW(1001); }, ".rotation", "0.001 to 1000");
  LevelBuilder b;
  b.part([](schema::Part::Builder p) {
    addKeys(p, {0, 1});
    p.getMotion().getKeys()[1].initRotation().setW(0);
  });
  const auto level = b.tryCompile();
  ASSERT_FALSE(bool(level));
  EXPECT_EQ(level.error().path, "parts[0].motion.keys[1].rotation");
  EXPECT_NE(level.error().hint.find("[0,0,0,1]"), std::string::npos) << level.error().text();
}

TEST(CompileErrors, Friction) {
  for (const float f : {-0.1f, kNan, 100.5f, 3e38f, kInf}) {
    expectRefused([=](auto p) { p.setFriction(f); }, ".friction", "from 0 to 100");
  }
  LevelBuilder max;
  EXPECT_TRUE(bool(max.part([](auto p) { p.setFriction(100); }).tryCompile()));
}

TEST(CompileErrors, Roles) {
  expectRefused([](auto p) { p.initKill().setDamage(kNan); }, ".kill.damage", "a finite number");
  expectRefused([](auto p) { p.initKill().setCooldown(-1); }, ".kill.cooldown", "seconds");
  expectRefused(
      [](auto p) {
        set(p.initConveyor().initVelocity(), {kNan, 0, 0});
      },
      ".conveyor.velocity", "three numbers");
  expectRefused(
      [](auto p) {
        set(p.initConveyor().initAngular(), {0, kInf, 0});
      },
      ".conveyor.angular", "three numbers");
  expectRefused(
      [](auto p) {
        set(p.initJumpPad().initVelocity(), {0, kNan, 0});
      },
      ".jumpPad.velocity", "three numbers");
}

TEST(CompileErrors, VanishTimerWithoutAPeriod) {
  const auto timer = [](float delay, float away, float phase) {
    return [=](schema::Part::Builder p) {
      auto v = p.initVanish();
      v.setTrigger(schema::VanishTrigger::TIMER);
      v.setDelay(delay);
      v.setAway(away);
      v.setPhase(phase);
    };
  };
  expectRefused(timer(0, 0, 0), ".vanish", "less than one tick");
  for (const float phase : {kNan, kInf, -kInf}) {
    expectRefused(timer(0, 1, phase), ".vanish.phase", "seconds");
  }
  LevelBuilder fine;
  EXPECT_TRUE(bool(fine.part(timer(0, 1, -5)).tryCompile()));
}

TEST(CompileErrors, Teleport) {
  expectRefused(
      [](auto p) {
        set(p.initTeleport().initPosition(), {0, kInf, 0});
      },
      ".teleport.position", "three numbers from -1000000");
  expectRefused([](auto p) { p.initTeleport().setYaw(kNan); }, ".teleport.yaw", "radians");
}

TEST(CompileErrors, Boost) {
  for (const float bad : {0.0f, -1.0f, kNan, 101.0f}) {
    expectRefused([=](auto p) { p.initBoost().setWalkSpeed(bad); }, ".boost.walkSpeed", "above 0");
    expectRefused([=](auto p) { p.initBoost().setJumpSpeed(bad); }, ".boost.jumpSpeed", "above 0");
  }
  expectRefused([](auto p) { p.initBoost().setJumpMore(kNan); }, ".boost.jumpMore", "studs/s");
  expectRefused([](auto p) { p.initBoost().setWalkSpeed(2), p.getBoost().setSeconds(-1); },
                ".boost.seconds", "expected 0 or more");
  for (const float bad : {-1.0f, kNan, 101.0f}) {
    expectRefused([=](auto p) { p.initBoost().setGravity(bad); }, ".boost.gravity", "0 to 100");
  }
  expectRefused([](auto p) { p.initBoost().setGravity(11); }, ".boost.gravity", "2158.2");
  expectRefused([](auto p) { p.initBoost(); }, ".boost", "changes nothing");
}

TEST(CompileErrors, NegativeSeconds) {
  expectRefused([](auto p) { p.initFall().setDelay(-1); }, ".fall.delay", "expected 0 or more");
  expectRefused([](auto p) { p.initFall().setAway(kNan); }, ".fall.away", "expected 0 or more");
  expectRefused([](auto p) { p.initFall().setSeconds(0); }, ".fall.seconds", "less than one tick");
  expectRefused([](auto p) { p.initFall().setSpeed(-1); }, ".fall.speed", "expected 0 or more");
  for (const float bad : {-1.0f, kNan}) {
    expectRefused([=](auto p) { p.initVanish().setDelay(bad); }, ".vanish.delay",
                  "expected 0 or more");
    expectRefused([=](auto p) { p.initVanish().setAway(bad); }, ".vanish.away",
                  "expected 0 or more");
  }
  expectRefused([](auto p) { p.initTrip().setSeconds(-1); }, ".trip.seconds", "expected 0 or more");
  expectRefused([](auto p) { p.initTrip().setAfter(-1); }, ".trip.after", "expected 0 or more");
  expectRefused([](auto p) { p.initMotion().setSeconds(-1); }, ".motion.seconds",
                "expected 0 or more");
}

TEST(CompileErrors, FallsOfPartsThatNothingCanTouch) {
  const auto fall = [](float delay, float seconds, float speed) {
    return [=](schema::Part::Builder p) {
      p.setTouch(false);
      auto f = p.initFall();
      f.setDelay(delay);
      f.setSeconds(seconds);
      f.setSpeed(speed);
    };
  };
  expectRefused(fall(-1, 1, 0), ".fall.delay", "expected 0 or more");
  expectRefused(fall(1, 0, 0), ".fall.seconds", "less than one tick");
  expectRefused(fall(1, 1, -1), ".fall.speed", "expected 0 or more");
  expectRefused(fall(1e6f, 1e6f, 0), ".fall", "longer than the allowed 20 minutes");
  expectRefused([](auto p) { p.setTouch(false), p.initFall(), p.initMotion(); }, ".fall",
                "cannot have 'motion' or 'vanish'");
}

TEST(CompileErrors, DynamicPartsThatLoseTheirCollision) {
  expectRefused([](auto p) { p.setAnchored(false), p.initVanish(); }, ".vanish", "cannot vanish");
  expectRefused([](auto p) { p.setAnchored(false), p.initOneWay(); }, ".oneWay", "cannot vanish");
}

TEST(CompileErrors, OneWayWithoutADirection) {
  for (const Vec3 bad : {Vec3{}, Vec3{kNan, 0, 0}}) {
    expectRefused([=](auto p) { set(p.initOneWay().initDirection(), bad); }, ".oneWay.direction",
                  "direction");
  }
}

TEST(CompileErrors, OneTouchStartsOneTimedEffect) {
  expectRefused([](auto p) { p.initFall(), p.initVanish(); }, ".fall",
                "cannot have 'motion' or 'vanish'");
  expectRefused([](auto p) { p.initFall(), p.initMotion(); }, ".fall",
                "cannot have 'motion' or 'vanish'");
  expectRefused(
      [](auto p) {
        p.initVanish();
        addKeys(p, {0, 1});
        set(p.getMotion().getKeys()[1].initPosition(), {0, 9, 0});
        p.getMotion().setTrigger(schema::MotionTrigger::TOUCH);
      },
      ".motion.trigger", "already starts");
}

PartSetter button(const char* signal, float seconds = 5) {
  return [=](schema::Part::Builder p) {
    p.initButton().setSignal(signal);
    p.getButton().setSeconds(seconds);
  };
}
PartSetter door(const char* signal) {
  return [=](schema::Part::Builder p) {
    p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
    p.getVanish().setSignal(signal);
  };
}

TEST(CompileErrors, SignalsWithoutASourceOrAReceiver) {
  expectRefused(door("gate"), ".vanish.signal", "no button starts the signal 'gate'");
  expectRefused(door(""), ".vanish.signal", "the name of a button's signal, found none");
  expectRefused(button("gate"), ".button.signal", "no part responds to the signal 'gate'");
  expectRefused(button(""), ".button.signal", "expected the name of a signal, found none");
  expectRefused(button("gate", -1), ".button.seconds", "expected 0 or more");
  expectRefused(button("gate", 0), ".button.seconds", "less than one tick");
  expectRefused([](auto p) { p.initVanish().setSignal("gate"); }, ".vanish.signal", "trigger");
  expectRefused([](auto p) { p.initMotion().setSignal("gate"); }, ".motion.signal", "trigger");
  expectRefused([](auto p) { p.initMotion().setTrigger(schema::MotionTrigger::SIGNAL); },
                ".motion.signal", "the name of a button's signal, found none");
  LevelBuilder untouchable, fine;
  untouchable.part([](auto p) { button("gate")(p), p.setTouch(false); }).part(door("gate"));
  EXPECT_EQ(untouchable.tryCompile().error().path, "parts[1].vanish.signal");
  EXPECT_TRUE(bool(fine.part(button("gate")).part(door("gate")).part(button("gate")).tryCompile()));
}

TEST(CompileErrors, ButtonsOfOneSignalMustAgree) {
  LevelBuilder b;
  b.part(button("gate", 5)).part(door("gate")).part(button("gate", 6));
  const auto level = b.tryCompile();
  ASSERT_FALSE(bool(level));
  EXPECT_EQ(level.error().path, "parts[2].button.seconds");
  EXPECT_NE(level.error().message.find("parts[0]"), std::string::npos) << level.error().text();
}

TEST(CompileErrors, MotionKeys) {
  expectRefused([](auto p) { addKeys(p, {0, 2, 1.5f}); }, ".motion.keys[2].time", "not earlier");
  expectRefused([](auto p) { addKeys(p, {-1}); }, ".motion.keys[0].time", "not earlier");
  expectRefused([](auto p) { addKeys(p, {0, kNan}); }, ".motion.keys[1].time", "seconds");
  expectRefused(
      [](auto p) {
        addKeys(p, {0, 1201});
      },
      ".motion.keys", "longer than the allowed 20 minutes");
  expectRefused(
      [](auto p) {
        addKeys(p, {0, 1});
        set(p.getMotion().getKeys()[1].initPosition(), {0, kNan, 0});
      },
      ".motion.keys[1].position", "three numbers");
  expectRefused(
      [](auto p) {
        addKeys(p, {0, 1});
        p.getMotion().getKeys()[0].initRotation().setW(0);
      },
      ".motion.keys[0].rotation", "0.001 to 1000");
  expectRefused([](auto p) { p.initMotion().setOffset(kInf); }, ".motion.offset", "seconds");
}

TEST(CompileErrors, Spin) {
  expectRefused(
      [](auto p) {
        set(p.initMotion().initSpin().initAxis(), {0, 0, 0});
      },
      ".motion.spin.axis", "direction");
  expectRefused([](auto p) { p.initMotion().initSpin().setSpeed(kNan); }, ".motion.spin.speed",
                "rad/s");
  expectRefused([](auto p) { p.initMotion().initSpin().setSpeed(0.001f); }, ".motion.spin.speed",
                "longer than");
  expectRefused(
      [](auto p) {
        auto spin = p.initMotion().initSpin();
        spin.setSpeed(1);
        set(spin.initPivot(), {kNan, 0, 0});
      },
      ".motion.spin.pivot", "three numbers");
}

TEST(CompileErrors, Hulls) {
  const auto hullOf = [](uint32_t count, Vec3 last) {
    return [=](schema::Part::Builder p) {
      p.setShape(schema::Shape::HULL);
      auto vertices = p.initHulls(2)[0].initVertices(4);
      for (uint32_t i = 0; i < 4; ++i)
        set(vertices[i], {i == 1 ? 1.f : 0.f, i == 2 ? 1.f : 0.f, i == 3 ? 1.f : 0.f});
      auto second = p.getHulls()[1].initVertices(count);
      for (uint32_t i = 0; i < count; ++i) set(second[i], last * float(i));
    };
  };
  expectRefused(hullOf(3, {1, 1, 1}), ".hulls[1].vertices", "4 to 255 vertices, found 3");
  expectRefused(hullOf(256, {1, 1, 1}), ".hulls[1].vertices", "found 256");
  expectRefused(hullOf(5, {kNan, 1, 1}), ".hulls[1].vertices", "numbers");
  expectRefused(hullOf(5, {1e38f, 1, 1}), ".hulls[1].vertices", "numbers");
}

TEST(CompileErrors, Spawns) {
  for (const float yaw : {kNan, kInf, 1e30f}) {
    LevelBuilder b;
    b.spawn({0, 0, 0}).spawn({0, 0, 0}, yaw);
    const auto level = b.tryCompile();
    ASSERT_FALSE(bool(level)) << yaw;
    EXPECT_EQ(level.error().path, "spawns[1].yaw");
    EXPECT_NE(level.error().message.find("radians"), std::string::npos);
  }
  LevelBuilder b;
  b.spawn({kNan, 0, 0});
  EXPECT_EQ(b.tryCompile().error().path, "spawns[0].position");
}

TEST(CompileErrors, PhysicsCarryTheirPath) {
  LevelBuilder b;
  b.physics([](auto p) { p.setGravity(-1); });
  EXPECT_EQ(b.tryCompile().error().path, "physics.gravity");
}

TEST(Compile, AnEmptyLevelIsValid) {
  const Level level = LevelBuilder().compile();
  EXPECT_EQ(level.partCount(), 0u);
  EXPECT_EQ(level.view().colliderCount, 0u);
  EXPECT_FALSE(level.hasMotion());
}

TEST(Compile, TinyPartsAreAsThickAsTheEngineMakesThem) {
  const Level level = LevelBuilder().block({0, 0, 0}, {0.001f, 1, 3}).compile();
  const Vec3 half = level.view().colliders[0].shape.half;
  EXPECT_FLOAT_EQ(maxf(half.x, half.z), 1.5f);
  EXPECT_FLOAT_EQ(minf(half.x, minf(half.y, half.z)), 0.025f);
}

TEST(Compile, DirectionsMayHaveAnyLength) {
  for (const float length : {1e-5f, 1.0f, 1e15f, 3e30f, 3e38f}) {
    LevelBuilder b;
    b.block({0, 0, 0}, {1, 1, 1}, [=](auto p) {
      set(p.initOneWay().initDirection(), {0, -length, 0});
    });
    const Level level = b.compile();
    EXPECT_NEAR(level.view().roles[0].oneWay.y, -1, 1e-6f) << length;
  }
}

TEST(Compile, SceneryHasNoColliderButKeepsItsIndex) {
  LevelBuilder b;
  b.block({0, 0, 0}, {1, 1, 1}, [](auto p) { p.setSolid(false); });
  b.block({0, 5, 0}, {1, 1, 1}, [](auto p) { p.setSolid(false), p.initKill(); });
  b.block({0, 9, 0}, {1, 1, 1});
  const Level level = b.compile();
  ASSERT_EQ(level.view().colliderCount, 2u);
  EXPECT_EQ(level.view().colliders[0].part, 1u);
  EXPECT_EQ(level.view().bounds[0].flags & (kSolid | kKill), kKill);
  EXPECT_EQ(level.view().colliders[1].part, 2u);
}

TEST(Compile, OnlyTouchablePartsHaveTouchRoles) {
  LevelBuilder b;
  b.block({0, 0, 0}, {1, 1, 1}, [](auto p) {
    p.setTouch(false), p.initKill(), p.initJumpPad(), p.initVanish(), p.initConveyor();
  });
  EXPECT_EQ(b.compile().view().bounds[0].flags & (kTouchRoles | kConveyor), kConveyor);
}

}  // namespace
}  // namespace obby::level
