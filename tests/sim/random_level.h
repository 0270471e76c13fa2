// Random small levels for property tests: any shape, rotation and size, and most roles. rapidcheck
// draws them, and shrinks a failing level to few parts.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <ostream>
#include <vector>

#include "sim/simulator.h"
#include "support/level_builder.h"

namespace obby {

// Prints a failing case for rapidcheck, which finds the function by its name.
inline void showValue(const Vec3& v, std::ostream& out) {
  out << "{" << v.x << ", " << v.y << ", " << v.z << "}";
}

}  // namespace obby

namespace obby::test {

inline rc::Gen<float> between(float lo, float hi) {
  return rc::gen::map(rc::gen::inRange(0, 10001),
                      [=](int k) { return lo + (hi - lo) * float(k) / 10000; });
}
// Samples uniformly in the logarithm: values from 0.1 to 1 are as likely as from 1 to 10.
inline rc::Gen<float> extentBetween(float lo, float hi) {
  return rc::gen::map(between(0, 1), [=](float u) { return lo * std::pow(hi / lo, u); });
}
inline rc::Gen<Vec3> vecOf(const rc::Gen<float>& of) {
  return rc::gen::build<Vec3>(rc::gen::set(&Vec3::x, of), rc::gen::set(&Vec3::y, of),
                              rc::gen::set(&Vec3::z, of));
}

struct PartSpec {
  int shape;
  Vec3 position, size, turn;  // `turn`: yaw and pitch; all components also set details of the role
  int role;
};

inline std::ostream& operator<<(std::ostream& out, const PartSpec& p) {
  out << "shape " << p.shape << " role " << p.role << " at ";
  for (const Vec3& v : {p.position, p.size, p.turn}) showValue(v, out);
  return out;
}

inline rc::Gen<PartSpec> partSpecs() {
  const auto size = rc::gen::oneOf(extentBetween(0.05f, 8), extentBetween(0.05f, 2048));
  return rc::gen::build<PartSpec>(rc::gen::set(&PartSpec::shape, rc::gen::inRange(0, 7)),
                                  rc::gen::set(&PartSpec::position, vecOf(between(-15, 15))),
                                  rc::gen::set(&PartSpec::size, vecOf(size)),
                                  rc::gen::set(&PartSpec::turn, vecOf(between(-3.2f, 3.2f))),
                                  rc::gen::set(&PartSpec::role, rc::gen::inRange(0, 17)));
}

inline void setHull(schema::Part::Builder part, const PartSpec& spec) {
  auto vertices = part.initHulls(1)[0].initVertices(8);
  Random random(17, uint64_t(spec.turn.z * 1000) + 10000);
  for (uint32_t i = 0; i < 8; ++i) {
    const Vec3 corner{random.unit() - 0.5f, random.unit() - 0.5f, random.unit() - 0.5f};
    support::set(vertices[i], mul(spec.size, corner));
  }
}

inline void setFall(schema::Fall::Builder fall, const PartSpec& spec) {
  fall.setDelay(0.1f);
  fall.setSpeed(spec.turn.x > 0 ? 0.0f : 10.0f);
  fall.setAway(0.5f);
  fall.setSolid(spec.turn.y > 0);
}

// Makes a part move when touched, and kill a player whom it squeezes.
inline void setTriggered(schema::Part::Builder part, const PartSpec& spec) {
  auto motion = part.initMotion();
  motion.setTrigger(schema::MotionTrigger::TOUCH);
  motion.setRepeat(schema::Repeat(int(absf(spec.turn.x)) % 3));
  motion.setCarries(spec.turn.y > 0);
  auto keys = motion.initKeys(2);
  support::set(keys[0].initPosition(), spec.position);
  support::set(keys[1].initPosition(), spec.position + spec.turn);
  keys[1].setTime(1);
  part.setSqueeze(schema::Squeeze::KILL);
}

inline void setRole(schema::Part::Builder part, const PartSpec& spec) {
  const Vec3 v = spec.turn * 30.0f;
  switch (spec.role) {
    case 1:
      part.initKill().setDamage(20), part.getKill().setCooldown(0.2f);
      part.setByRoot(spec.turn.x > 1);
      return;
    case 2: support::set(part.initJumpPad().initVelocity(), v); return;
    case 3: support::set(part.initConveyor().initVelocity(), v); return;
    case 4: part.initVanish().setDelay(0.2f); return;
    case 5:
      part.initVanish().setTrigger(schema::VanishTrigger::TIMER);
      part.getVanish().setDelay(0.5f), part.getVanish().setAway(0.5f);
      return;
    case 6:
      part.initMotion().initSpin().setSpeed(0.1f + absf(spec.turn.z));
      part.getMotion().setCarries(spec.turn.x > 0);
      return;
    case 7: return setFall(part.initFall(), spec);
    case 8: support::set(part.initTeleport().initPosition(), v * 0.2f); return;
    case 9:
      part.initBoost().setWalkSpeed(2), part.getBoost().setSeconds(0.5f);
      part.getBoost().setGravity(spec.turn.x < -1 ? 0 : spec.turn.x < 1 ? 1 : 4);
      return;
    case 10: part.initOneWay(); return;
    case 11: part.initSeat(); return;
    case 12: part.initTrip().setSeconds(0.3f); return;
    case 13: part.initKill().setDamage(-20), part.getKill().setCooldown(0.2f); return;
    case 14: return setTriggered(part, spec);
    default: return;
  }
}

inline void addParts(support::LevelBuilder& b, const std::vector<PartSpec>& specs) {
  for (const PartSpec& spec : specs) {
    b.part([=](schema::Part::Builder part) {
      part.setShape(schema::Shape(spec.shape));
      support::set(part.initPosition(), spec.position);
      support::set(part.initSize(), spec.size);
      support::setRotation(part.initRotation(), spec.turn.x, spec.turn.y);
      if (spec.shape == int(schema::Shape::HULL)) setHull(part, spec);
      setRole(part, spec);
    });
  }
}

inline Result<level::Level> compile(const std::vector<PartSpec>& specs) {
  support::LevelBuilder b;
  addParts(b, specs);
  b.spawn({0, 8, 0});
  return b.tryCompile();
}

// Returns a random action, which is held for up to 40 ticks. It depends only on seed and tick, so
// any tick of any world can be repeated.
inline sim::Action actionAt(uint64_t seed, uint32_t tick) {
  Random random(seed, tick / (5 + seed % 36));
  return {Turns(random.next()), random.below(10) != 0, random.below(3) == 0};
}

inline bool isFinite(const sim::World& w) {
  const auto finite = [](Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  return finite(w.position) && finite(w.velocity) && std::isfinite(w.health);
}

}  // namespace obby::test
