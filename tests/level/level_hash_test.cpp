// The level's digest changes with everything that can change a trajectory, and with nothing else.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "support/level_builder.h"

namespace obby::level {
namespace {

using support::set;
using PartSetter = support::LevelBuilder::PartSetter;

uint64_t hashOf(const PartSetter& more) {
  support::LevelBuilder b;
  b.block({0, 0, 0}, {10, 1, 10}).block({0, 5, 0}, {4, 1, 4}, [&](schema::Part::Builder p) {
    p.initKill();
    p.initJumpPad();
    p.initConveyor();
    auto v = p.initVanish();
    v.setTrigger(schema::VanishTrigger::TIMER);
    v.setDelay(1);
    more(p);
  });
  return b.compile().hash();
}

void spin(schema::Part::Builder p, float speed, Vec3 pivot, bool carries) {
  auto m = p.initMotion();
  m.initSpin().setSpeed(speed);
  set(m.getSpin().initPivot(), pivot);
  m.setCarries(carries);
}

TEST(LevelHash, ChangesWithEachFieldThatMatters) {
  const std::vector<PartSetter> changes = {
      [](auto) {},
      [](auto p) {
        set(p.initPosition(), {0, 5, 0.01f});
      },
      [](auto p) {
        set(p.initSize(), {4, 1, 4.01f});
      },
      [](auto p) { support::setRotation(p.initRotation(), 0.1f); },
      [](auto p) { p.setShape(schema::Shape::BALL); },
      [](auto p) { p.setShape(schema::Shape::WEDGE); },
      [](auto p) { p.setSolid(false); },
      [](auto p) { p.setTouch(false); },
      [](auto p) { p.setFriction(0.2f); },
      [](auto p) { p.getKill().setDamage(10); },
      [](auto p) { p.getKill().setCooldown(1); },
      [](auto p) { p.disownKill(); },
      [](auto p) {
        set(p.getConveyor().initVelocity(), {1, 0, 0});
      },
      [](auto p) {
        set(p.getConveyor().initAngular(), {0, 1, 0});
      },
      [](auto p) {
        set(p.getJumpPad().initVelocity(), {0, 50, 0});
      },
      [](auto p) { p.getJumpPad().setKeepSideways(false); },
      [](auto p) { p.getVanish().setTrigger(schema::VanishTrigger::TOUCH); },
      [](auto p) { p.getVanish().setDelay(2); },
      [](auto p) { p.getVanish().setAway(2); },
      [](auto p) { p.getVanish().setPhase(0.5f); },
      [](auto p) { spin(p, 1, {}, false); },
      [](auto p) { spin(p, 1.5f, {}, false); },
      [](auto p) {
        spin(p, 1, {1, 0, 0}, false);
      },
      [](auto p) { spin(p, 1, {}, true); },
      [](auto p) { p.getVanish().setInverted(true); },
      [](auto p) { p.getKill().setDamage(-5); },
      [](auto p) { p.setByRoot(true); },
      [](auto p) { p.getKill().setDamage(-5), p.getKill().setCooldown(1); },
      [](auto p) {
        set(p.initTeleport().initPosition(), {1, 0, 0});
      },
      [](auto p) {
        set(p.initTeleport().initPosition(), {2, 0, 0});
      },
      [](auto p) { p.initTeleport().setTurns(true); },
      [](auto p) { p.initTeleport().setTurns(true), p.getTeleport().setYaw(1); },
      [](auto p) { p.initTeleport().setKeepVelocity(true); },
      [](auto p) { p.initBoost().setWalkSpeed(2); },
      [](auto p) { p.initBoost().setWalkSpeed(3); },
      [](auto p) { p.initBoost().setJumpSpeed(2); },
      [](auto p) { p.initBoost().setJumpMore(2); },
      [](auto p) { p.initBoost().setJumpMore(2), p.getBoost().setSeconds(1); },
      [](auto p) { p.initBoost().setJumpMore(2), p.getBoost().setForever(true); },
      [](auto p) { p.initBoost().setGravity(0.5f); },
      [](auto p) { p.initBoost().setGravity(0); },
      [](auto p) { p.initBoost().setResets(true); },
      [](auto p) { p.initOneWay(); },
      [](auto p) {
        set(p.initOneWay().initDirection(), {1, 0, 0});
      },
      [](auto p) { p.setSqueeze(schema::Squeeze::KILL); },
      [](auto p) { p.initSeat(); },
      [](auto p) { p.initTrip(); },
      [](auto p) { p.initTrip().setSeconds(1); },
      [](auto p) { p.initTrip().setAfter(2); },
      [](auto p) { spin(p, 1, {}, true), p.getMotion().setTrigger(schema::MotionTrigger::TOUCH); },
      [](auto p) {
        spin(p, 1, {}, true), p.getMotion().setTrigger(schema::MotionTrigger::TOUCH);
        p.getMotion().setSeconds(9);
      },
  };
  std::set<uint64_t> seen;
  for (size_t i = 0; i < changes.size(); ++i) {
    EXPECT_TRUE(seen.insert(hashOf(changes[i])).second) << "change " << i << " does not show";
  }
}

// A part with a single key is always at that key, and its conveyor turns about it.
TEST(LevelHash, IgnoresThePositionOfAPartWithKeys) {
  const auto hashWith = [](float x, float key) {
    return hashOf([=](schema::Part::Builder p) {
      set(p.initPosition(), {x, 5, 0});
      set(p.getConveyor().initAngular(), {0, 1, 0});
      set(p.initMotion().initKeys(1)[0].initPosition(), {key, 5, 0});
    });
  };
  EXPECT_EQ(hashWith(0, 9), hashWith(1, 9));
  EXPECT_NE(hashWith(0, 9), hashWith(0, 8));
}

uint64_t hashOfFall(const std::function<void(schema::Fall::Builder)>& more) {
  support::LevelBuilder b;
  return b.block({0, 0, 0}, {4, 1, 4}, [&](auto p) { more(p.initFall()); }).compile().hash();
}

TEST(LevelHash, ChangesWithTheNumbersOfAFallAndOfAButton) {
  std::set<uint64_t> seen{
      hashOfFall([](auto) {}),
      hashOfFall([](auto f) { f.setDelay(1); }),
      hashOfFall([](auto f) { f.setSeconds(2); }),
      hashOfFall([](auto f) { f.setSpeed(5); }),
      hashOfFall([](auto f) { f.setAway(1); }),
      hashOfFall([](auto f) { f.setSolid(false); }),
  };
  for (int i = 0; i < 5; ++i) {
    support::LevelBuilder b;
    b.block({0, 0, 0}, {4, 1, 4}, [=](auto p) {
      auto button = p.initButton();
      button.setSignal("door");
      if (i == 1) button.setSeconds(1);
      if (i == 2) button.setForever(true);
      if (i == 3) button.setRestarts(true);
    });
    b.block({0, 9, 0}, {4, 1, 4}, [=](auto p) {
      p.initVanish().setTrigger(schema::VanishTrigger::SIGNAL);
      p.getVanish().setSignal("door");
      if (i == 4) p.getVanish().setDelay(1);
    });
    seen.insert(b.compile().hash());
  }
  EXPECT_EQ(seen.size(), 11u);
}

TEST(LevelHash, IgnoresNamesAndAppearance) {
  const uint64_t plain = hashOf([](auto) {});
  EXPECT_EQ(plain, hashOf([](schema::Part::Builder p) {
              p.setName("Lava");
              p.setTransparency(0.5f);
              p.initColor().setR(1);
              p.initSource().setPath("Workspace/Lava");
              p.initTags(1).set(0, "KillBrick");
              p.initEvidence(1);
              p.initCheckpoint();
              p.initGoal();
            }));
}

TEST(LevelHash, IgnoresSpawnsAndChangesWithPhysics) {
  support::LevelBuilder a, b, c;
  a.block({0, 0, 0}, {1, 1, 1});
  b.block({0, 0, 0}, {1, 1, 1}).spawn({1, 2, 3});
  c.block({0, 0, 0}, {1, 1, 1}).physics([](auto p) { p.setAirAccel(100); });
  EXPECT_EQ(a.compile().hash(), b.compile().hash());
  EXPECT_NE(a.compile().hash(), c.compile().hash());
}

TEST(LevelHash, IsTheSameForEveryCompilation) {
  const auto builder = [] { return support::boxArena(80, 3); };
  EXPECT_EQ(builder().compile().hash(), builder().compile().hash());
}

}  // namespace
}  // namespace obby::level
