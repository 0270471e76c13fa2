// Finds parts that carry along what stands on them: by tag, kit marker or velocity.
#include <algorithm>
#include <cmath>

#include "engine/classes/class_defaults.h"
#include "import/document/pose_math.h"
#include "import/roles/role.h"
#include "import/roles/surface_speed.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kConveyorTags = {"conveyor", "conveyorbelt", "conveyors"};
constexpr float kDefaultSpeed = 10;
constexpr float kAligned = 0.99f;  // min share of a saved velocity along one axis of part or world
constexpr float kMaxSpeed = 1000;  // studs/s
constexpr float kMaxTurn = 1000;   // rad/s

Vec3 forward(const PartDraft& part, double speed) { return -part.pose.rotation.z * float(speed); }

// Returns true if the velocity lies along an axis. Velocities that designers set do; those that
// physics left behind do not.
bool isAligned(const PartDraft& part, Vec3 v) {
  const Mat3& r = part.pose.rotation;
  const Vec3 local = toLocal(r, v);
  const auto max = [](Vec3 a) { return maxf(absf(a.x), maxf(absf(a.y), absf(a.z))); };
  return std::max(max(v), max(local)) >= kAligned * length(v);
}

}  // namespace

bool isUpward(Vec3 v) { return v.y > 0 && v.y > 2 * length(Vec3{v.x, 0, v.z}); }

void giveConveyor(PartDraft& part, Conveyor conveyor, std::string reason, bool guessed) {
  const float speed = length(conveyor.velocity), turn = length(conveyor.angular);
  const bool moves =
      (speed >= kMinSpeed || turn >= 0.01f) && speed <= kMaxSpeed && turn <= kMaxTurn;
  if (part.conveyor || !moves || !part.solid) return;
  part.conveyor = conveyor;
  part.evidence.push_back({"conveyor", std::move(reason), guessed});
}

void conveyorFromTags(RoleContext& context) {
  context.eachTagged(kConveyorTags, [&](InstanceId id, const std::string& tag) {
    const auto stated = context.tree.number(id, "Speed");
    for (PartDraft* part : context.partsOf(id)) {
      const auto own = context.tree.number(part->id, "Speed");
      const double speed = own ? *own : stated.value_or(kDefaultSpeed);
      giveConveyor(*part, {forward(*part, speed), {}}, "tag " + tag, !own && !stated);
    }
  });
}

void conveyorFromMarkers(RoleContext& context) {
  context.eachMarker([&](InstanceId marker, InstanceId owner) {
    PartDraft* part = context.part(owner);
    const Instance& instance = context.tree.at(marker);
    if (!part || !containsWord(markerWords(context.tree, marker), "conveyor")) return;
    const auto value = instance.properties.find("Value");
    if (instance.className == "StringValue" && value != instance.properties.end()) {
      // This kit states the speed along the world's Z axis.
      if (const auto speed = numberFrom(value->second))
        giveConveyor(*part, {{0, 0, float(*speed)}, {}}, "marker " + instance.name, false);
      return;
    }
    const auto speed = context.tree.number(marker, "Speed");
    giveConveyor(*part, {forward(*part, speed.value_or(kDefaultSpeed)), {}},
                 "marker " + instance.name, !speed);
  });
}

void conveyorFromVelocity(RoleContext& context) {
  for (PartDraft& part : context.level.parts) {
    const Instance& instance = context.tree.at(part.id);
    const auto velocity = get<Vec3>(instance, "Velocity");
    const auto angular = get<Vec3>(instance, "RotVelocity");
    const bool anchored = get<bool>(instance, "Anchored");
    if (!anchored || !isFinite(velocity) || !isFinite(angular)) continue;
    if (length(velocity) < kMinSpeed && length(angular) < kMinSpeed) continue;
    if (part.conveyor || part.jumpPad) continue;
    if (length(velocity) >= kMinSpeed && !isAligned(part, velocity)) {
      context.level.noteIgnored("saved velocity along no axis of the part or the world",
                                context.tree.path(part.id),
                                "treated as left over from physics, not as a conveyor");
      continue;
    }
    if (isUpward(velocity))
      giveJumpPad(part, {velocity, true}, "saved Velocity of an anchored part", true);
    else
      giveConveyor(part, {velocity, angular}, "saved Velocity of an anchored part", false);
  }
}

}  // namespace obby::importer
