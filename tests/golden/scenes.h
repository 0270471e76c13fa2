// The scenes with committed state hashes. Together they use every shape and behaviour.
#pragma once

#include <string>

#include "support/level_builder.h"

namespace obby::golden {

using schema::Part;
using support::LevelBuilder;

inline void key(schema::MotionKey::Builder k, float time, Vec3 at) {
  k.setTime(time);
  support::set(k.initPosition(), at);
}

inline LevelBuilder floorWith(const LevelBuilder::PartSetter& more) {
  return LevelBuilder().block({0, -1, 0}, {60, 2, 60}, more).spawn({0, 3, 0});
}

inline LevelBuilder shapes() {
  LevelBuilder b = floorWith({});
  Random random(5, 0);
  for (int i = 0; i < 60; ++i) {
    const float x = 50 * random.unit() - 25, y = 6 * random.unit(), z = 50 * random.unit() - 25;
    const Vec3 size{1 + 5 * random.unit(), 1 + 5 * random.unit(), 1 + 5 * random.unit()};
    const float yaw = 6 * random.unit(), pitch = i % 3 == 0 ? 0 : 3 * random.unit();
    b.block({x, y, z}, size, [=](Part::Builder p) {
      p.setShape(schema::Shape(i % 5));
      support::setRotation(p.initRotation(), yaw, pitch);
    });
  }
  return b;
}

inline LevelBuilder movers(bool carries) {
  LevelBuilder b = floorWith([](Part::Builder p) { p.initKill().setDamage(1); });
  for (int i = 0; i < 12; ++i) {
    const Vec3 at{float(i % 4) * 8 - 12, 1 + float(i / 4) * 3, float(i / 4) * 9 - 9};
    b.block(at, {5, 1, 5}, [=](Part::Builder p) {
      auto motion = p.initMotion();
      motion.setCarries(carries);
      motion.setRepeat(i % 2 == 0 ? schema::Repeat::PING_PONG : schema::Repeat::LOOP);
      auto keys = motion.initKeys(2);
      key(keys[0], 0, at);
      key(keys[1], 1.3f + float(i) * 0.37f, at + Vec3{6, float(i % 3), -4});
      keys[1].setEasing(schema::Easing(i % 11));
      if (i % 3 == 0) motion.initSpin().setSpeed(0.7f * float(i + 1));
    });
  }
  return b;
}

inline LevelBuilder roles() {
  LevelBuilder b = floorWith([](Part::Builder p) {
    support::set(p.initConveyor().initVelocity(), {3, 0, 1});
  });
  b.block({6, 0.5f, 0}, {4, 1, 4}, [](Part::Builder p) {
    support::set(p.initJumpPad().initVelocity(), {5, 80, 0});
  });
  b.block({-6, 2, 0}, {4, 1, 4}, [](Part::Builder p) { p.initVanish().setDelay(0.4f); });
  b.block({0, 2, 8}, {4, 1, 4}, [](Part::Builder p) {
    p.initVanish().setTrigger(schema::VanishTrigger::TIMER);
    p.getVanish().setDelay(1);
  });
  b.block({0, 4, -8}, {6, 8, 1}, [](Part::Builder p) {
    p.setSolid(false);
    p.initKill().setDamage(20);
    p.getKill().setCooldown(0.5f);
  });
  b.block({12, 1, 12}, {10, 2, 10}, [](Part::Builder p) { p.setFriction(0.02f); });
  return b;
}

// Returns a floor with many parts at random places. `setter` sets up each part by its index.
template <class Setter>
LevelBuilder scattered(int count, Setter setter) {
  LevelBuilder b = floorWith({});
  Random random(21, uint64_t(count));
  for (int i = 0; i < count; ++i) {
    const Vec3 at{44 * random.unit() - 22, 5 * random.unit(), 44 * random.unit() - 22};
    const Vec3 size{1 + 6 * random.unit(), 0.5f + 4 * random.unit(), 1 + 6 * random.unit()};
    const float yaw = 6 * random.unit(), pitch = random.unit() - 0.5f;
    b.block(at, size, [=](Part::Builder p) {
      support::setRotation(p.initRotation(), yaw, pitch);
      setter(p, i);
    });
  }
  return b;
}

inline LevelBuilder scatteredOf(schema::Shape shape) {
  return scattered(40, [=](Part::Builder p, int) { p.setShape(shape); });
}

// Returns a level of hulls in the form of octahedra, with eight faces and six corners.
inline LevelBuilder hulls() {
  return scattered(30, [](Part::Builder p, int i) {
    p.setShape(schema::Shape::HULL);
    const float r = 2 + 0.1f * float(i);
    const Vec3 corners[6] = {{r, 0, 0}, {-r, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, r}, {0, 0, -r}};
    auto vertices = p.initHulls(1)[0].initVertices(6);
    for (uint32_t k = 0; k < 6; ++k) support::set(vertices[k], corners[k]);
  });
}

// Returns a level with beams that spin about a vertical or a horizontal axis, through a pivot away
// from their centre.
inline LevelBuilder spinners() {
  LevelBuilder b = floorWith({});
  for (int i = 0; i < 9; ++i) {
    const Vec3 at{float(i % 3) * 14 - 14, 1 + float(i % 2), float(i / 3) * 14 - 14};
    b.block(at, {10, 0.8f, 1.2f}, [=](Part::Builder p) {
      auto spin = p.initMotion().initSpin();
      spin.setSpeed(0.5f + 0.3f * float(i));
      support::set(spin.initAxis(), i % 2 == 0 ? Vec3{0, 1, 0} : Vec3{0, 0, 1});
      p.getMotion().setCarries(i % 3 == 0);
    });
  }
  return b;
}

// Returns a level with parts of extreme sizes: a plain, a sheet, a needle, a hill.
inline LevelBuilder extremes() {
  return LevelBuilder()
      .block({0, -1000, 0}, {2048, 2000, 2048})
      .block({0, 3, 0}, {30, 0.05f, 30})
      .block({8, 4, 8}, {0.05f, 8, 0.05f})
      .block({-30, 0, 0}, {40, 20, 40},
             [](Part::Builder p) { support::setRotation(p.initRotation(), 1, 0.7f); })
      .spawn({0, 6, 0});
}

// Returns a level with steps of growing height, up to more than a player can climb, under a sloping
// ceiling.
inline LevelBuilder stairs() {
  LevelBuilder b = floorWith({});
  for (int i = 0; i < 12; ++i) {
    const float rise = 0.3f + 0.12f * float(i), at = float(i) * 3 - 15;
    b.block({at, 0.15f * float(i) * rise, 0}, {3, 0.3f * float(i) * rise + 0.1f, 20});
  }
  b.block({0, 9, 0}, {50, 1, 20},
          [](Part::Builder p) { support::setRotation(p.initRotation(), 1.5707963f, 0.1f); });
  return b;
}

inline LevelBuilder slopes() {
  LevelBuilder b = floorWith([](Part::Builder p) { p.setFriction(0.05f); });
  for (int i = 0; i < 8; ++i) {
    b.block({float(i % 4) * 12 - 18, 1, float(i / 4) * 20 - 10}, {8, 1, 16}, [=](Part::Builder p) {
      support::setRotation(p.initRotation(), 0.4f * float(i), 0.2f * float(i));
      p.setFriction(0.02f * float(i));
    });
  }
  return b;
}

inline LevelBuilder pads() {
  return scattered(20, [](Part::Builder p, int i) {
    auto pad = p.initJumpPad();
    support::set(pad.initVelocity(), {float(i % 5) * 20 - 40, 30 + 10 * float(i % 7), 15});
    pad.setKeepSideways(i % 2 == 0);
  });
}

inline LevelBuilder vanishing() {
  return scattered(30, [](Part::Builder p, int i) {
    auto vanish = p.initVanish();
    if (i % 2 == 0) vanish.setTrigger(schema::VanishTrigger::TIMER);
    vanish.setDelay(0.2f * float(i % 4));
    vanish.setAway(0.5f + 0.1f * float(i));
    vanish.setPhase(0.3f * float(i));
  });
}

// Returns a level with boosts that change gravity, some of them for ever, and parts that only the
// root can touch.
inline LevelBuilder weights() {
  return scattered(40, [](Part::Builder p, int i) {
    if (i % 4 == 3) {
      p.setSolid(false);
      p.setByRoot(true);
      p.initKill().setDamage(5);
      p.getKill().setCooldown(0.5f);
      return;
    }
    auto boost = p.initBoost();
    boost.setGravity(0.3f * float(1 + i % 6));
    boost.setSeconds(0.5f * float(i % 3));
    boost.setForever(i % 8 == 5);
    boost.setResets(i % 5 == 4);
  });
}

// Returns a level with two air jumps, trusses, seats and pads.
inline LevelBuilder airJumps() {
  return scattered(40,
                   [](Part::Builder p, int i) {
                     if (i % 6 == 1) p.setShape(schema::Shape::TRUSS);
                     if (i % 6 == 2) p.initSeat();
                     if (i % 6 == 3) support::set(p.initJumpPad().initVelocity(), {10, 60, 0});
                   })
      .physics([](auto p) { p.setAirJumps(2); });
}

inline LevelBuilder killers() {
  return scattered(25, [](Part::Builder p, int i) {
    p.setSolid(i % 3 != 0);
    p.initKill().setDamage(float(5 + 10 * (i % 4)));
    p.getKill().setCooldown(0.25f * float(i % 3));
  });
}

// Returns a level with trusses at random places: upright, turned, tilted, hanging, moving,
// vanishing.
inline LevelBuilder trusses() {
  LevelBuilder b = floorWith({});
  Random random(12, 0);
  for (int i = 0; i < 40; ++i) {
    const float x = 40 * random.unit() - 20, z = 40 * random.unit() - 20;
    const float height = 4 + 12 * random.unit(), bottom = i % 4 == 3 ? 6.0f : 0.0f;
    const float yaw = 6 * random.unit(), pitch = i % 5 == 4 ? 0.4f : 0.0f;
    const Vec3 at{x, bottom + height / 2, z};
    b.block(at, {2, height, 2}, [=](Part::Builder p) {
      p.setShape(schema::Shape::TRUSS);
      support::setRotation(p.initRotation(), yaw, pitch);
      if (i % 10 == 1) p.initVanish().setDelay(1);
      if (i % 10 != 2) return;
      auto motion = p.initMotion();
      motion.setCarries(true);
      motion.setRepeat(schema::Repeat::PING_PONG);
      auto keys = motion.initKeys(2);
      key(keys[0], 0, at);
      key(keys[1], 3, at + Vec3{3, 2, -2});
    });
  }
  return b;
}

// Returns a level with everything that a touch can start: doors opened by four buttons, falls,
// motions, boosts, trips.
inline LevelBuilder clocks() {
  LevelBuilder b = scattered(48, [](Part::Builder p, int i) {
    const std::string signal = "signal " + std::to_string(i % 4);
    auto button = [&] {
      p.initButton().setSignal(signal);
      p.getButton().setSeconds(0.7f + float(i % 4));
      p.getButton().setRestarts(i % 4 == 1);
    };
    auto door = [&](bool inverted) {
      auto vanish = p.initVanish();
      vanish.setTrigger(schema::VanishTrigger::SIGNAL);
      vanish.setSignal(signal);
      vanish.setInverted(inverted);
    };
    auto slide = [&](schema::MotionTrigger trigger) {
      auto motion = p.initMotion();
      motion.setTrigger(trigger);
      motion.setRepeat(schema::Repeat(i % 3));
      motion.setCarries(i % 2 == 0);
      if (trigger == schema::MotionTrigger::SIGNAL) motion.setSignal(signal);
      auto keys = motion.initKeys(2);
      key(keys[0], 0, Vec3{p.asReader().getPosition().getX(), 2, 0});
      key(keys[1], 1.1f, Vec3{p.asReader().getPosition().getX(), 5, 6});
    };
    switch (i / 4 % 8) {
      case 0: return button();
      case 1: return door(i % 2 == 0);
      case 2: return p.initFall().setSpeed(i % 2 == 0 ? 0.0f : 8.0f);
      case 3: return slide(schema::MotionTrigger::TOUCH);
      case 4: return slide(schema::MotionTrigger::SIGNAL);
      case 5:
        return p.initBoost().setWalkSpeed(0.6f + 0.5f * float(i % 4)),
               p.getBoost().setSeconds(0.5f * float(i % 3));
      case 6: return p.initTrip().setSeconds(0.5f);
      default: p.initBoost().setJumpMore(20), p.getBoost().setForever(true);
    }
  });
  return b;
}

// Returns a level with teleporters, seats, one-way parts, healing parts, and presses above them.
inline LevelBuilder places() {
  LevelBuilder b = scattered(40, [](Part::Builder p, int i) {
    switch (i % 5) {
      case 0:
        support::set(p.initTeleport().initPosition(), {float(i) - 20, 6, float(i % 7) * 5 - 15});
        p.getTeleport().setKeepVelocity(i % 2 == 0);
        p.getTeleport().setTurns(i % 3 == 0);
        return;
      case 1: p.initSeat(); return;
      case 2:
        support::set(p.initOneWay().initDirection(), {0, i % 2 == 0 ? 1.0f : 0.0f, 1});
        return;
      case 3:
        p.initKill().setDamage(i % 2 == 0 ? -5.0f : 8.0f), p.getKill().setCooldown(0.3f);
        return;
      default: p.setSqueeze(schema::Squeeze::KILL);
    }
    const Vec3 at{float(i % 8) * 6 - 21, 9, float(i / 8) * 9 - 18};
    auto motion = p.initMotion();
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    key(keys[0], 0, at);
    key(keys[1], 1.5f, at - Vec3{0, 8, 0});
  });
  return b;
}

}  // namespace obby::golden
