#include "gen/place/place_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "gen/place/place_scripts.h"
#include "level/record_values.h"

namespace obby::gen {

namespace {

constexpr float kBetween = 60;                      // studs from one level to the next
constexpr float kPlaceFallMargin = 40;              // studs below all parts at which a fall ends
constexpr float kFarthest = level::kMaxCoordinate;  // studs: max coordinate of a part in a level
constexpr float kDensity = 0.7f, kFriction = 0.3f;  // plastic
constexpr float kJumpPower = 1.06f;                 // launch speed / JumpPower
constexpr uint32_t kPlastic = 256, kNeon = 288;
constexpr uint64_t kFrameBytes = 4096;  // max size of everything but the levels

// Returns an upper bound of a part's extent in any rotation, including its motion.
Box boundsOf(const PartSketch& part) {
  const Vec3 half = abs(part.size) * 0.5f;
  const float radius = length(half);
  const Vec3 around{radius, radius, radius};
  Box box{part.position - around, part.position + around};
  if (part.motion) {
    for (const MotionSketch::Key& key : part.motion->keys) {
      box = join(box, {key.position - around, key.position + around});
    }
  }
  return box;
}

const char* classOf(const PartSketch& part, bool spawn) {
  if (spawn) return "SpawnLocation";
  switch (part.shape) {
    case schema::Shape::WEDGE: return "WedgePart";
    case schema::Shape::CORNER_WEDGE: return "CornerWedgePart";
    case schema::Shape::TRUSS: return "TrussPart";
    default: return "Part";
  }
}

const char* tagOf(const PartSketch& part) {
  if (part.goal) return "Goal";
  if (part.checkpoint > 0) return "Checkpoint";
  return part.kill ? "KillBrick" : nullptr;
}

// Returns true for a carrier, which physics must move: it is unanchored and held by an
// AlignPosition.
bool isDriven(const PartSketch& part) {
  return part.motion && part.motion->carries && !part.motion->keys.empty();
}

}  // namespace

PlaceFile::PlaceFile(const Generator& generator, uint64_t maxBytes)
    : params_(generator.reach().params()), maxBytes_(maxBytes) {}

void PlaceFile::writeProperties(const PartSketch& part, Vec3 shift) {
  xml_.flag("Anchored", part.anchored && !isDriven(part));
  xml_.frame("CFrame", part.position + shift, toMat3(part.rotation));
  xml_.vector("size", part.size);
  xml_.color("Color3uint8",
             uint32_t(part.color.r) << 16 | uint32_t(part.color.g) << 8 | part.color.b);
  xml_.token("Material", part.kill ? kNeon : kPlastic);
  if (part.shape == schema::Shape::CYLINDER) xml_.token("shape", 2);
  if (part.shape == schema::Shape::BALL) xml_.token("shape", 0);
  // A part that appears on a signal is away until the signal starts.
  const bool there = part.solid && !(part.vanish && part.vanish->inverted);
  xml_.flag("CanCollide", there);
  xml_.number("Transparency", there ? part.transparency : 0.8f);
  if (part.friction >= 0 || part.density >= 0 || part.kill) {
    xml_.physical(part.density >= 0 ? part.density : kDensity,
                  part.friction >= 0 ? part.friction : kFriction, part.frictionWeight);
  }
  if (!(part.conveyor == Vec3{})) xml_.vector("Velocity", part.conveyor);
  if (const char* tag = tagOf(part)) xml_.tags(tag);
}

void PlaceFile::writeScript(const char* name, const std::string& source) {
  xml_.begin("Script", name);
  xml_.source(source);
  xml_.endProperties();
  xml_.end();
}

void PlaceFile::writeCarrier(const PartSketch& part, Vec3 shift) {
  const MotionSketch& motion = *part.motion;
  constexpr float kForce = 1e7f, kResponse = 200;
  xml_.begin("Attachment", "Attachment");
  xml_.endProperties();
  xml_.end();
  const uint32_t attachment = xml_.lastReferent();
  const float distance = length(motion.keys.back().position - motion.keys.front().position);
  xml_.begin("AlignPosition", "AlignPosition");
  xml_.reference("Attachment0", attachment);
  xml_.token("Mode", 0);
  xml_.vector("Position", motion.keys.front().position + shift);
  xml_.number("MaxForce", kForce);
  xml_.number("Responsiveness", kResponse);
  xml_.number("MaxVelocity", distance / maxf(motion.keys.back().time, 0.1f));
  xml_.endProperties();
  xml_.end();
  xml_.begin("AlignOrientation", "AlignOrientation");
  xml_.reference("Attachment0", attachment);
  xml_.token("Mode", 0);
  xml_.frame("CFrame", {}, toMat3(part.rotation));
  xml_.flag("RigidityEnabled", true);
  xml_.endProperties();
  xml_.end();
}

void PlaceFile::writePart(const PartSketch& part, const std::vector<PartSketch>& all, Vec3 shift) {
  const bool spawn = added_ == 0 && &part == &all.front();
  xml_.begin(classOf(part, spawn), part.name);
  writeProperties(part, shift);
  xml_.endProperties();
  if (isDriven(part)) writeCarrier(part, shift);
  for (const PlaceScript& script : scriptsOf(part, all, shift)) {
    writeScript(script.name, script.source);
  }
  xml_.end();
}

Error PlaceFile::full(const std::string& within) const {
  return makeError(
      fmt::format("a place file can hold at most {} of these levels {}", added_, within),
      "lower --count, and write the rest to another file with --first");
}

Status PlaceFile::add(const Generated& level) {
  const std::vector<PartSketch>& parts = level.sketch.parts();
  Box box = boundsOf(parts.front());
  for (const PartSketch& part : parts) box = join(box, boundsOf(part));
  const Vec3 shift{added_ == 0 ? 0.0f : float(int32_t(next_ - box.lo.x + 1)), 0, 0};
  if (box.hi.x + shift.x > kFarthest)
    return full(fmt::format("side by side within {:.0f} studs", kFarthest));
  const size_t before = levels_.size();
  xml_.begin("Model", level.name);
  xml_.endProperties();
  for (const PartSketch& part : parts) writePart(part, parts, shift);
  xml_.end();
  if (levels_.size() + kFrameBytes > maxBytes_) {
    levels_.resize(before);
    return full(fmt::format("in {} bytes", maxBytes_));
  }
  next_ = box.hi.x + shift.x + kBetween;
  lowest_ = std::min(lowest_, box.lo.y);
  ++added_;
  return {};
}

std::string PlaceFile::finish() {
  std::string levels;
  levels.swap(levels_);
  levels_ += io::kXmlBegin;
  xml_.begin("Workspace", "Workspace");
  xml_.number("Gravity", params_.gravity);
  xml_.number("FallenPartsDestroyHeight", float(int32_t(lowest_ - kPlaceFallMargin)));
  xml_.endProperties();
  levels_ += levels;
  xml_.end();
  xml_.begin("StarterPlayer", "StarterPlayer");
  xml_.number("CharacterWalkSpeed", params_.walkSpeed);
  xml_.flag("CharacterUseJumpPower", true);
  xml_.number("CharacterJumpPower", params_.jumpSpeed / kJumpPower);
  xml_.endProperties();
  xml_.end();
  xml_.begin("ServerScriptService", "ServerScriptService");
  xml_.endProperties();
  const PlaceScript script = checkpointScript();
  writeScript(script.name, script.source);
  xml_.end();
  levels_ += io::kXmlEnd;
  return std::move(levels_);
}

}  // namespace obby::gen
