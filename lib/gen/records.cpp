// Writes sketches as records. Fields with default values stay unset.
#include <algorithm>
#include <cmath>

#include "gen/generator.h"
#include "gen/physics.h"
#include "level/record_values.h"

namespace obby::gen {

namespace {

constexpr float kRecordFallMargin = 24;  // studs below the lowest part at which a fall ends

using level::set;

bool isZero(Vec3 v) { return v == Vec3{}; }
bool isIdentity(Quat q) { return q.x == 0 && q.y == 0 && q.z == 0; }

void writeMotion(const MotionSketch& from, const PartSketch& part, schema::Motion::Builder to) {
  if (!from.keys.empty()) {
    auto keys = to.initKeys(uint32_t(from.keys.size()));
    for (uint32_t i = 0; i < keys.size(); ++i) {
      set(keys[i].initPosition(), from.keys[i].position);
      if (!isIdentity(part.rotation)) set(keys[i].initRotation(), part.rotation);
      keys[i].setTime(from.keys[i].time);
      if (!from.smooth) continue;
      keys[i].setEasing(schema::Easing::SINE);
      keys[i].setDirection(schema::EasingDirection::IN_OUT);
    }
    to.setRepeat(schema::Repeat::PING_PONG);
  }
  if (from.spin != 0) {
    auto spin = to.initSpin();
    spin.setSpeed(from.spin);
    set(spin.initAxis(), from.spinAxis);
    if (!isZero(from.spinPivot)) set(spin.initPivot(), from.spinPivot);
  }
  to.setOffset(from.offset);
  to.setCarries(from.carries);
}

void writeVanish(const PartSketch& from, schema::Vanish::Builder to) {
  to.setTrigger(from.vanish->trigger);
  to.setDelay(from.vanish->delay);
  if (from.vanish->trigger == schema::VanishTrigger::SIGNAL) {
    to.setSignal(from.signal);
  } else {
    to.setAway(from.vanish->away);
  }
  to.setPhase(from.vanish->phase);
  to.setInverted(from.vanish->inverted);
}

void writeRoles(const PartSketch& from, schema::Part::Builder to) {
  if (from.kill) to.initKill();
  if (from.goal) to.initGoal();
  if (from.checkpoint > 0) to.initCheckpoint().setStage(from.checkpoint);
  if (!isZero(from.conveyor)) set(to.initConveyor().initVelocity(), from.conveyor);
  if (!isZero(from.pad)) set(to.initJumpPad().initVelocity(), from.pad);
  if (from.vanish) writeVanish(from, to.initVanish());
  if (from.motion) writeMotion(*from.motion, from, to.initMotion());
  if (from.button) {
    auto button = to.initButton();
    button.setSignal(from.signal);
    button.setSeconds(from.button->seconds);
  }
}

void writePart(const PartSketch& from, schema::Part::Builder to) {
  to.setName(from.name);
  to.setShape(from.shape);
  set(to.initPosition(), from.position);
  if (!isIdentity(from.rotation)) set(to.initRotation(), from.rotation);
  set(to.initSize(), from.size);
  auto color = to.initColor();
  color.setR(from.color.r);
  color.setG(from.color.g);
  color.setB(from.color.b);
  if (!from.solid) to.setSolid(false);
  if (!from.anchored) to.setAnchored(false);
  if (from.friction >= 0) to.setFriction(from.friction);
  if (from.frictionWeight != 1) to.setFrictionWeight(from.frictionWeight);
  if (from.density >= 0) to.setDensity(from.density);
  to.setTransparency(from.transparency);
  writeRoles(from, to);
}

void writeRegion(const Stop& from, const Quat& facing, schema::Region::Builder to) {
  set(to.initPosition(), from.feet + Vec3{0, from.extents.y / 2, 0});
  if (!isIdentity(facing)) set(to.initRotation(), facing);
  set(to.initSize(), from.extents);
}

Quat facingOf(const Stop& stop, const Sketch& sketch) {
  return sketch.parts()[stop.part].shape == schema::Shape::BLOCK
             ? sketch.parts()[stop.part].rotation
             : Quat{};
}

// Rounds to eighths of a stud, which have short decimal texts.
float inEighths(float studs) { return std::floor(studs * 8 + 0.5f) / 8; }

// Writes the intended route, a hint for learning. Long routes are thinned to the schema's limit and
// keep the goal.
void writeRoute(const Generated& from, schema::Query::Builder to) {
  constexpr size_t kMaxPlaces = 4096;
  const std::vector<Vec3>& line = from.sketch.line();
  const size_t step = (line.size() + kMaxPlaces - 3) / (kMaxPlaces - 1);
  auto route = to.initRoute(uint32_t((line.size() - 2) / step + 2));
  for (uint32_t i = 0; i < route.size(); ++i) {
    const Vec3& at = line[std::min(i * step, line.size() - 1)];
    set(route[i], {inEighths(at.x), inEighths(at.y), inEighths(at.z)});
  }
  to.setDifficulty(from.difficulty);
}

float lowest(const Sketch& sketch) {
  float y = 0;
  for (const PartSketch& p : sketch.parts()) {
    y = std::min(y, p.position.y - length(p.size * 0.5f));  // lowest point in any rotation
  }
  return y;
}

}  // namespace

void Generator::writeLevel(const Generated& from, schema::Level::Builder to) const {
  const Sketch& sketch = from.sketch;
  to.setName(from.name);
  auto physics = to.initPhysics();
  // Cannot fail: Generator::make checked the names.
  (void)setPhysics(physics, recipe_.physics);
  const auto saysWhereFallsEnd = [](const NamedNumber& n) { return n.name == "fallenPartsHeight"; };
  if (std::none_of(recipe_.physics.begin(), recipe_.physics.end(), saysWhereFallsEnd))
    physics.setFallenPartsHeight(float(int32_t(lowest(sketch) - kRecordFallMargin)));
  auto parts = to.initParts(uint32_t(sketch.parts().size()));
  for (uint32_t i = 0; i < parts.size(); ++i) writePart(sketch.parts()[i], parts[i]);
  auto spawns = to.initSpawns(uint32_t(sketch.stops().size()) - 1);
  for (uint32_t i = 0; i < spawns.size(); ++i) {
    const Stop& stop = sketch.stops()[i];
    spawns[i].setName(sketch.parts()[stop.part].name);
    spawns[i].setStage(int32_t(i));
    set(spawns[i].initPosition(), stop.feet);
    spawns[i].setYaw(radiansFromTurns(stop.heading));
    spawns[i].setPart(int32_t(stop.part));
  }
}

void Generator::writeQuery(const Generated& from, schema::Query::Builder to) {
  const auto& stops = from.sketch.stops();
  to.setId(from.query);
  to.setLevel(from.name);
  auto start = to.initStart();
  writeRegion(stops.front(), facingOf(stops.front(), from.sketch), start.initRegion());
  start.getRegion().setName("Start");
  auto goal = to.initGoal();
  writeRegion(stops.back(), facingOf(stops.back(), from.sketch), goal);
  goal.setName("Goal");
  auto waypoints = to.initWaypoints(uint32_t(from.limits.waypoints.size()));
  for (uint32_t i = 0; i < waypoints.size(); ++i) {
    const Stop& stop = stops[from.limits.waypoints[i]];
    writeRegion(stop, facingOf(stop, from.sketch), waypoints[i].initRegion());
    waypoints[i].getRegion().setName(from.sketch.parts()[stop.part].name);
  }
  if (from.limits.maxJumps > 0) to.setMaxJumps(int32_t(from.limits.maxJumps));
  to.setTimeLimit(from.limits.timeLimit);
  if (from.sketch.plantedWhat().empty()) writeRoute(from, to);
}

}  // namespace obby::gen
