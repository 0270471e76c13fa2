// Golden scenes with dynamic bodies.
#pragma once

#include "golden/scenes.h"

namespace obby::golden {

// Returns a level with one body of each shape in a pen with a conveyor.
inline LevelBuilder dynamicBodies() {
  LevelBuilder b = floorWith({});
  for (int side = 0; side < 4; ++side) {
    const float at = side % 2 == 0 ? 12.0f : -12.0f;
    b.block(side < 2 ? Vec3{at, 3, 0} : Vec3{0, 3, at}, side < 2 ? Vec3{2, 6, 26} : Vec3{26, 6, 2});
  }
  b.block({0, 0.25f, 8}, {20, 0.5f, 6}, [](Part::Builder p) {
    support::set(p.initConveyor().initVelocity(), {6, 0, 0});
  });
  for (int i = 0; i < 10; ++i) {
    const Vec3 at{float(i % 4) * 5 - 8, 3 + float(i / 4) * 4, float(i / 4) * 5 - 6};
    b.block(at, {3, 2 + float(i % 3), 3}, [=](Part::Builder p) {
      p.setAnchored(false);
      p.setShape(schema::Shape(i % 6));
      p.setDensity(0.2f + 0.1f * float(i));
      p.setElasticity(0.1f * float(i % 5));
      support::setRotation(p.initRotation(), 0.4f * float(i), i % 2 == 0 ? 0.0f : 0.9f);
    });
  }
  return b;
}

inline LevelBuilder dynamicStack() {
  LevelBuilder b = floorWith({});
  b.block({0, 1, 0}, {14, 2, 14}, [](Part::Builder p) {
    auto motion = p.initMotion();
    motion.setCarries(true);
    motion.setRepeat(schema::Repeat::PING_PONG);
    auto keys = motion.initKeys(2);
    key(keys[0], 0, {0, 1, 0});
    key(keys[1], 3, {9, 4, -6});
  });
  for (int i = 0; i < 5; ++i) {
    b.block({4, 4 + 3.05f * float(i), -3}, {3, 3, 3},
            [](Part::Builder p) { p.setAnchored(false); });
  }
  return b;
}

// Returns a level with seats on a turning floor, which carries some of them over its edge.
inline LevelBuilder dynamicSeats() {
  LevelBuilder b = floorWith([](Part::Builder p) {
    support::set(p.initConveyor().initAngular(), {0, 1.5f, 0});
  });
  for (int i = 0; i < 12; ++i) {
    const Vec3 at{float(i % 4) * 9 - 13, 1.5f + float(i % 3), float(i / 4) * 9 - 9};
    b.block(at, {3, 1, 3}, [=](Part::Builder p) {
      p.setAnchored(false);
      p.initSeat();
      support::setRotation(p.initRotation(), 0.5f * float(i));
    });
  }
  return b;
}

}  // namespace obby::golden
