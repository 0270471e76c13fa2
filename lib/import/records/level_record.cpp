// Copies the draft into a Cap'n Proto level record, field by field.
#include "import/records/level_record.h"

#include <algorithm>
#include <cmath>

#include "engine/classes/class_defaults.h"
#include "import/document/pose_math.h"
#include "import/level/doubts.h"
#include "import/records/record_values.h"
#include "io/utf8.h"
#include "level/bodies.h"
#include "level/params.h"

namespace obby::importer {
namespace {

static_assert(uint16_t(Shape::hull) == uint16_t(schema::Shape::HULL));
static_assert(uint16_t(Easing::cubic) == uint16_t(schema::Easing::CUBIC));
static_assert(uint16_t(EasingDirection::inOut) == uint16_t(schema::EasingDirection::IN_OUT));
static_assert(uint16_t(Bearing::harder) == uint16_t(schema::Bearing::HARDER));
static_assert(uint16_t(Repeat::pingPong) == uint16_t(schema::Repeat::PING_PONG));

void setSource(schema::PartSource::Builder to, const PartDraft& part, const Tree& tree) {
  to.setPath(validUtf8(tree.path(part.id)));
  const auto indices = tree.indices(part.id);
  auto list = to.initIndices(unsigned(indices.size()));
  for (unsigned i = 0; i < indices.size(); ++i) list.set(i, indices[i]);
  const Instance& instance = tree.at(part.id);
  if (const auto* guid = property<std::string>(instance, "UniqueId")) to.setGuid(validUtf8(*guid));
  const auto own = instance.attributes.find("GUID");
  if (own != instance.attributes.end())
    if (const auto* guid = std::get_if<std::string>(&own->second)) to.setGuid(validUtf8(*guid));
  to.setClassName(validUtf8(instance.className));
}

void setMotion(schema::Motion::Builder to, const Motion& motion) {
  auto keys = to.initKeys(unsigned(motion.keys.size()));
  for (unsigned i = 0; i < motion.keys.size(); ++i) {
    const MotionKey& key = motion.keys[i];
    keys[i].setTime(key.time);
    setVector(keys[i].initPosition(), key.pose.position);
    setRotation(keys[i].initRotation(), key.pose.rotation);
    keys[i].setEasing(schema::Easing(key.easing));
    keys[i].setDirection(schema::EasingDirection(key.direction));
  }
  to.setRepeat(schema::Repeat(motion.repeat));
  if (motion.spin) {
    auto spin = to.initSpin();
    setVector(spin.initAxis(), motion.spin->axis);
    spin.setSpeed(motion.spin->speed);
    setVector(spin.initPivot(), motion.spin->pivot);
  }
  to.setOffset(motion.offset);
  to.setTrigger(schema::MotionTrigger(motion.trigger));
  if (!motion.signal.empty()) to.setSignal(motion.signal);
  to.setCarries(motion.carries);
}

void setRoles(schema::Part::Builder to, const PartDraft& part) {
  if (part.kill) {
    auto kill = to.initKill();
    kill.setDamage(part.kill->damage);
    kill.setCooldown(part.kill->cooldown);
  }
  if (part.conveyor) {
    auto conveyor = to.initConveyor();
    setVector(conveyor.initVelocity(), part.conveyor->velocity);
    setVector(conveyor.initAngular(), part.conveyor->angular);
  }
  if (part.jumpPad) {
    auto pad = to.initJumpPad();
    setVector(pad.initVelocity(), part.jumpPad->velocity);
    pad.setKeepSideways(part.jumpPad->keepSideways);
  }
  if (part.vanish) {
    auto vanish = to.initVanish();
    vanish.setTrigger(part.vanish->timer            ? schema::VanishTrigger::TIMER
                      : part.vanish->signal.empty() ? schema::VanishTrigger::TOUCH
                                                    : schema::VanishTrigger::SIGNAL);
    if (!part.vanish->signal.empty()) vanish.setSignal(part.vanish->signal);
    vanish.setDelay(part.vanish->delay);
    vanish.setAway(part.vanish->away);
    vanish.setPhase(part.vanish->phase);
    vanish.setInverted(part.vanish->inverted);
  }
  if (part.teleport) {
    auto teleport = to.initTeleport();
    setVector(teleport.initPosition(), part.teleport->position);
    teleport.setYaw(part.teleport->yaw);
    teleport.setTurns(part.teleport->turns);
    teleport.setKeepVelocity(true);  // setting the CFrame of a character keeps its velocity
  }
  if (part.boost) {
    auto boost = to.initBoost();
    boost.setWalkSpeed(part.boost->walkSpeed);
    boost.setJumpSpeed(part.boost->jumpSpeed);
    boost.setSeconds(part.boost->seconds);
    boost.setForever(part.boost->forever);
    boost.setGravity(part.boost->gravity);
    boost.setResets(part.boost->resets);
  }
  if (part.trip) to.initTrip().setSeconds(part.trip->seconds);
  if (part.button) {
    auto button = to.initButton();
    button.setSignal(part.button->signal);
    button.setSeconds(part.button->seconds);
    button.setForever(part.button->forever);
    button.setRestarts(part.button->restarts);
  }
  if (part.seat) to.initSeat();
  if (part.oneWay) to.initOneWay();
  to.setClimbable(part.climbable);
  if (part.checkpoint) to.initCheckpoint().setStage(*part.checkpoint);
  if (part.goal) to.initGoal().setStage(*part.goal);
  if (part.motion) setMotion(to.initMotion(), *part.motion);
}

void setGeometry(schema::Part::Builder to, const PartDraft& part) {
  to.setShape(schema::Shape(part.shape));
  setVector(to.initPosition(), part.pose.position);
  setRotation(to.initRotation(), part.pose.rotation);
  setVector(to.initSize(), boundedSize(part.size));
  if (!part.hulls.empty()) {
    auto hulls = to.initHulls(unsigned(part.hulls.size()));
    for (unsigned h = 0; h < part.hulls.size(); ++h) {
      auto vertices = hulls[h].initVertices(unsigned(part.hulls[h].size()));
      for (unsigned v = 0; v < part.hulls[h].size(); ++v) setVector(vertices[v], part.hulls[h][v]);
    }
  }
  to.setSolid(part.solid);
  to.setTouch(part.touch);
  to.setByRoot(part.byRoot);
  to.setAnchored(part.anchored);
}

void setPart(schema::Part::Builder to, const PartDraft& part, const Tree& tree) {
  to.setName(validUtf8(tree.at(part.id).name));
  setGeometry(to, part);
  to.setFriction(part.friction);
  to.setFrictionWeight(part.frictionWeight);
  to.setElasticity(part.elasticity);
  to.setDensity(part.density);
  auto color = to.initColor();
  color.setR(part.color.r);
  color.setG(part.color.g);
  color.setB(part.color.b);
  to.setTransparency(part.transparency);
  if (!part.material.empty()) to.setMaterial(std::string(part.material));
  setSource(to.initSource(), part, tree);
  setRoles(to, part);
  auto evidence = to.initEvidence(unsigned(part.evidence.size()));
  for (unsigned i = 0; i < part.evidence.size(); ++i) {
    evidence[i].setRole(part.evidence[i].role);
    evidence[i].setReason(validUtf8(part.evidence[i].reason));
    evidence[i].setGuessed(part.evidence[i].guessed);
  }
  auto doubts = to.initDoubts(unsigned(part.doubts.size()));
  for (unsigned i = 0; i < part.doubts.size(); ++i) doubts.set(i, validUtf8(part.doubts[i]));
  const auto& tags = tree.at(part.id).tags;
  auto list = to.initTags(unsigned(tags.size()));
  for (unsigned i = 0; i < tags.size(); ++i) list.set(i, validUtf8(tags[i]));
}

void setWorld(schema::PhysicsParams::Builder to, const World& world) {
  const World usual;
  const auto within = [](float v, float lo, float hi, float fallback) {
    return std::isnan(v) ? fallback : std::clamp(v, lo, hi);
  };
  to.setGravity(within(world.gravity, 0, kMaxGravity, usual.gravity));
  to.setAirJumps(world.airJumps);
  to.setWalkSpeed(within(world.walkSpeed, 0, 500, usual.walkSpeed));
  to.setJumpSpeed(within(world.jumpSpeed, 0, 1000, usual.jumpSpeed));
  to.setMaxSlope(within(world.maxSlope, 0, usual.maxSlope, usual.maxSlope));
  to.setMaxHealth(within(world.maxHealth, 1, 1e6f, usual.maxHealth));
  to.setHealthRegeneration(within(world.healthRegeneration, 0, 10, usual.healthRegeneration));
  to.setFallenPartsHeight(within(world.fallenPartsHeight, -50000, 50000, usual.fallenPartsHeight));
}

void setUnmodelled(schema::Level::Builder to, const LevelDraft& level) {
  auto list = to.initUnmodelled(unsigned(level.unmodelled.size()));
  unsigned i = 0;
  for (const auto& [kind, entry] : level.unmodelled) {
    list[i].setKind(validUtf8(kind));
    list[i].setCount(entry.count);
    list[i].setExample(validUtf8(entry.example));
    list[i].setNote(validUtf8(entry.note));
    list[i].setBearing(schema::Bearing(bearingOf(kind)));
    list[i].setAnywhere(entry.anywhere);
    ++i;
  }
}

}  // namespace

void setAvatar(schema::PhysicsParams::Builder to, const Avatar& avatar) {
  if (const level::Body* const body = level::findBody(avatar.body)) level::setBody(*body, to);
  if (avatar.height != 1) {
    to.setHipHeight(to.getHipHeight() * avatar.height);
    to.setRootHeight(to.getRootHeight() * avatar.height);
    to.setHeadBottom(to.getHeadBottom() * avatar.height);
    to.setBodyTop(to.getBodyTop() * avatar.height);
  }
  if (avatar.width != 1) {
    to.setBodyWidth(to.getBodyWidth() * avatar.width);
    to.setArmSpan(to.getArmSpan() * avatar.width);
  }
  if (!avatar.collider) return;
  to.setBodyWidth(avatar.collider->x);
  to.setBodyDepth(avatar.collider->z);
  if (avatar.colliderTouches) to.setArmSpan(avatar.collider->x);
}

std::string validUtf8(std::string_view text) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const io::Utf8Char c = io::nextChar(text, at);
    at += c.bytes;
    io::appendUtf8(out, c.code == 0 ? U'\xfffd' : c.code);  // a record's text ends at a zero
  }
  return out;
}

io::RecordBuilder levelRecord(const LevelDraft& level, const Tree& tree) {
  io::RecordBuilder record;
  auto to = record.root().initLevel();
  to.setName(validUtf8(level.name));
  auto source = to.initSource();
  source.setFile(validUtf8(level.file));
  source.setFormat(level.format);
  source.setPath(validUtf8(level.path));
  source.setPartsRead(level.partsRead);
  source.setPartsKept(uint32_t(level.parts.size()));
  source.setPartsCulled(level.partsCulled);
  setWorld(to.initPhysics(), level.world);
  setAvatar(to.getPhysics(), level.avatar);
  auto bodies = to.initBodies(unsigned(level.avatar.bodies.size()));
  for (unsigned i = 0; i < bodies.size(); ++i) bodies.set(i, level.avatar.bodies[i]);
  auto parts = to.initParts(unsigned(level.parts.size()));
  for (unsigned i = 0; i < level.parts.size(); ++i) setPart(parts[i], level.parts[i], tree);
  auto spawns = to.initSpawns(unsigned(level.spawns.size()));
  for (unsigned i = 0; i < level.spawns.size(); ++i) {
    const SpawnDraft& spawn = level.spawns[i];
    spawns[i].setName(validUtf8(spawn.name));
    spawns[i].setStage(spawn.stage);
    setVector(spawns[i].initPosition(), spawn.position);
    spawns[i].setYaw(spawn.yaw);
    spawns[i].setPart(spawn.part);
  }
  setUnmodelled(to, level);
  return record;
}

}  // namespace obby::importer
