// Levels for tests and benches in a few lines:
//   LevelBuilder b;
//   b.block({0, -1, 0}, {20, 2, 20});
//   b.part([](auto part) { part.setShape(schema::Shape::BALL); ... });
//   level::Level level = b.compile();
#pragma once

#include <capnp/message.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "base/random.h"
#include "level/level.h"
#include "math/angle.h"

namespace obby::support {

inline void set(schema::Vec3::Builder to, Vec3 v) {
  to.setX(v.x);
  to.setY(v.y);
  to.setZ(v.z);
}

// Sets a rotation about X, then about Y.
inline void setRotation(schema::Quat::Builder to, float yaw, float pitch = 0) {
  const SinCos y = sinCos(turnsFromRadians(yaw * 0.5f)), p = sinCos(turnsFromRadians(pitch * 0.5f));
  const Quat q = Quat{0, y.sin, 0, y.cos} * Quat{p.sin, 0, 0, p.cos};
  to.setX(q.x);
  to.setY(q.y);
  to.setZ(q.z);
  to.setW(q.w);
}

class LevelBuilder {
 public:
  using PartSetter = std::function<void(schema::Part::Builder)>;

  LevelBuilder& part(PartSetter setter) {
    parts_.push_back(std::move(setter));
    return *this;
  }

  // Adds a block; `more` sets further properties.
  LevelBuilder& block(Vec3 center, Vec3 size, PartSetter more = {}) {
    return part([=](schema::Part::Builder p) {
      set(p.initPosition(), center);
      set(p.initSize(), size);
      if (more) more(p);
    });
  }

  LevelBuilder& physics(std::function<void(schema::PhysicsParams::Builder)> setter) {
    physics_ = std::move(setter);
    return *this;
  }

  LevelBuilder& spawn(Vec3 feet, float yaw = 0) {
    spawns_.push_back({feet, yaw, 0});
    return *this;
  }

  schema::Level::Reader record() {
    message_ = std::make_shared<capnp::MallocMessageBuilder>();
    auto level = message_->initRoot<schema::Level>();
    level.setName("test");
    if (physics_) physics_(level.initPhysics());
    auto parts = level.initParts(uint32_t(parts_.size()));
    for (uint32_t i = 0; i < parts_.size(); ++i) parts_[i](parts[i]);
    auto spawns = level.initSpawns(uint32_t(spawns_.size()));
    for (uint32_t i = 0; i < spawns_.size(); ++i) {
      set(spawns[i].initPosition(), spawns_[i].feet);
      spawns[i].setYaw(spawns_[i].yaw);
    }
    return level.asReader();
  }

  Result<level::Level> tryCompile() { return level::Level::compile(record()); }

  // Compiles the level. A test that builds an invalid level by mistake stops here.
  level::Level compile() {
    auto level = tryCompile();
    if (!level) {
      std::fprintf(stderr, "bad test level: %s\n", level.error().text().c_str());
      std::abort();
    }
    return *std::move(level);
  }

 private:
  std::vector<PartSetter> parts_;
  std::vector<level::StartPose> spawns_;
  std::function<void(schema::PhysicsParams::Builder)> physics_;
  std::shared_ptr<capnp::MallocMessageBuilder> message_;  // shared, so builders can be copied
};

// Returns the scene for comparisons of engines (docs/physics.md, benches): a walled arena with a
// box for every 115 square studs. Half of the boxes are tilted, by up to 23 degrees. The player
// starts above the middle.
inline LevelBuilder boxArena(uint32_t boxes, uint64_t seed) {
  LevelBuilder b;
  Random random(seed, boxes);
  const float half = 0.5f * sqrtf32(float(boxes) * 115.0f);
  const auto uniform = [&random](float lo, float hi) { return lo + (hi - lo) * random.unit(); };
  b.block({0, -2, 0}, {2 * half + 8, 4, 2 * half + 8});
  for (int side = 0; side < 4; ++side) {
    const float s = side % 2 == 0 ? 1.0f : -1.0f, at = s * (half + 2);
    b.block(side < 2 ? Vec3{at, 10, 0} : Vec3{0, 10, at},
            side < 2 ? Vec3{4, 20, 2 * half} : Vec3{2 * half, 20, 4});
  }
  for (uint32_t i = 0; i < boxes; ++i) {
    const Vec3 size{uniform(2, 10.7f), uniform(0.7f, 5.7f), uniform(2, 10.7f)};
    const Vec3 center{uniform(-half, half), uniform(0, 8), uniform(-half, half)};
    const float yaw = uniform(0, 6.28f), pitch = i % 2 == 0 ? uniform(-0.4f, 0.4f) : 0.0f;
    b.block(center, size,
            [=](schema::Part::Builder p) { setRotation(p.initRotation(), yaw, pitch); });
  }
  b.spawn({0, 12, 0});
  return b;
}

// Returns the same arena with platforms that slide back and forth near the middle. Every second
// platform also turns.
inline LevelBuilder movingArena(uint32_t boxes, uint32_t movers, uint64_t seed) {
  LevelBuilder b = boxArena(boxes, seed);
  Random random(seed, boxes + movers);
  const float half = 0.5f * sqrtf32(float(boxes) * 115.0f);
  const auto uniform = [&random](float lo, float hi) { return lo + (hi - lo) * random.unit(); };
  for (uint32_t i = 0; i < movers; ++i) {
    const Vec3 at{uniform(-half, half), uniform(1, 8), uniform(-half, half)};
    const Vec3 to = at + Vec3{uniform(-12, 12), uniform(-2, 4), uniform(-12, 12)};
    const Vec3 size{uniform(3, 10), uniform(0.7f, 2), uniform(3, 10)};
    const float seconds = uniform(1.5f, 5);
    b.block(at, size, [=](schema::Part::Builder p) {
      auto motion = p.initMotion();
      motion.setCarries(true);
      motion.setRepeat(schema::Repeat::PING_PONG);
      auto keys = motion.initKeys(2);
      set(keys[0].initPosition(), at);
      set(keys[1].initPosition(), to);
      keys[1].setTime(seconds);
      if (i % 2 == 0) motion.initSpin().setSpeed(1);
    });
  }
  return b;
}

// Returns the same arena with eight moving platforms, and `boxes` dynamic boxes away from their
// motions. If `restless`, the boxes never fall asleep.
inline LevelBuilder bodyArena(uint32_t boxes, bool restless, uint64_t seed) {
  LevelBuilder b = movingArena(100, 8, seed);
  const level::Level fixed = b.compile();
  Random random(seed, 77);
  for (uint32_t placed = 0; placed < boxes;) {
    const Vec3 at{100 * random.unit() - 50, 9, 100 * random.unit() - 50};
    bool isFree = true;
    for (uint32_t i = 0; i < fixed.view().colliderCount; ++i) {
      const level::Bounds& bounds = fixed.view().bounds[i];
      const Vec3 reach{8, 20, 8};
      isFree &=
          !(bounds.flags & level::kMoving) || !overlaps(bounds.box(), {at - reach, at + reach});
    }
    if (!isFree) continue;
    b.block(at, {4, 4, 4}, [](schema::Part::Builder p) { p.setAnchored(false); });
    ++placed;
  }
  if (restless) b.physics([](schema::PhysicsParams::Builder p) { p.setSleepSpeed(0); });
  return b;
}

// Returns a winding course of platforms over a floor far below. All gaps and steps can be jumped.
inline LevelBuilder platformCourse(uint32_t platforms, uint64_t seed) {
  LevelBuilder b;
  Random random(seed, platforms);
  Vec3 at{0, 0, 0};
  b.block({0, -60, 0}, {2000, 2, 2000});
  for (uint32_t i = 1; i < platforms; ++i) {
    const Vec3 size{4 + 6 * random.unit(), 1, 4 + 6 * random.unit()};
    b.block(at - Vec3{0, 0.5f, 0}, size);
    const Vec3 ahead = directionOf(sinCos(turnsFromRadians(3 * float(i) / float(platforms))));
    const float gap = 10 + 5 * random.unit(), rise = 3 * random.unit() - 1;
    at += ahead * gap + Vec3{0, rise, 0};
  }
  b.spawn({0, 0, 0});
  return b;
}

}  // namespace obby::support
