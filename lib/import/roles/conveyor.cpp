// Parts that carry along what stands on them: by tag, kit marker, script or saved velocity.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/pose_math.h"
#include "import/roles/role.h"
#include "import/roles/surface_speed.h"

namespace obby::importer {
namespace {

const std::vector<std::string_view> kConveyorTags = {"conveyor", "conveyorbelt", "conveyors"};
constexpr float kDefaultSpeed = 10;
constexpr float kAligned = 0.99f;   // share of a saved velocity along one axis of part or world
constexpr float kMostSpeed = 1000;  // studs/s
constexpr float kMostTurn = 1000;   // rad/s

Vec3 forward(const PartDraft& part, double speed) { return -part.pose.rotation.z * float(speed); }

// A designer's velocity lies along an axis; the residue of physics does not.
bool isAligned(const PartDraft& part, Vec3 v) {
  const Mat3& r = part.pose.rotation;
  const Vec3 local = toLocal(r, v);
  const auto most = [](Vec3 a) { return maxf(absf(a.x), maxf(absf(a.y), absf(a.z))); };
  return std::max(most(v), most(local)) >= kAligned * length(v);
}

// Of several velocities the first counts.
void noteOthers(RoleContext& context, const PartDraft& part, Vec3 first, Vec3 now,
                const std::string& reason, std::set<InstanceId>& named) {
  if (!part.conveyor && !part.jumpPad) return;
  if (length(now - first) < kLeastSpeed || !named.insert(part.id).second) return;
  context.level.noteUnmodelled("conveyor that a script changes", context.tree.path(part.id),
                               "keeps its first velocity; " + reason);
}

bool isUntold(const ScriptEvent& event) {
  if (event.kind != EventKind::set) return false;
  if (event.property != "Velocity" && event.property != "RotVelocity") return false;
  return !event.vector || !isFinite(*event.vector);
}

// Whether a tag or a marker states what the part does, whatever a script sets.
bool isStated(const PartDraft& part) {
  return std::any_of(part.evidence.begin(), part.evidence.end(), [](const Evidence& e) {
    const bool carries = e.role == "conveyor" || e.role == "jumpPad";
    return carries && (e.reason.rfind("tag ", 0) == 0 || e.reason.rfind("marker ", 0) == 0);
  });
}

struct Lost {
  const char *kind, *what;
};

// `upward`: as far as the text tells, it throws.
Lost lostOf(const PartDraft& part, bool upward) {
  if (part.conveyor || part.jumpPad)
    return {"conveyor that a script changes", "keeps its known velocity; "};
  if (upward)
    return {"jump pad that a script computes",
            "throws no one without the tag JumpPad with a Power; "};
  return {"conveyor that a script computes",
          "carries no one without the tag Conveyor with a Speed; "};
}

void noteUntold(RoleContext& context, const PartDraft& part, const ScriptEvent& event,
                const std::string& reason) {
  const bool upward = event.vector && event.vector->x == 0 && event.vector->z == 0;
  const Lost lost = lostOf(part, upward);
  context.level.noteUnmodelled(lost.kind, context.tree.path(part.id), lost.what + reason);
}

}  // namespace

bool isUpward(Vec3 v) { return v.y > 0 && v.y > 2 * length(Vec3{v.x, 0, v.z}); }

void giveConveyor(PartDraft& part, Conveyor conveyor, std::string reason, bool guessed) {
  const float speed = length(conveyor.velocity), turn = length(conveyor.angular);
  const bool moves =
      (speed >= kLeastSpeed || turn >= 0.01f) && speed <= kMostSpeed && turn <= kMostTurn;
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

void conveyorFromScripts(RoleContext& context) {
  std::map<std::pair<InstanceId, std::string>, Vec3> first;
  std::set<InstanceId> named;
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      if (!timeline.byItself()) continue;
      for (const ScriptEvent& event : timeline.events) {
        PartDraft* part = event.kind == EventKind::set ? context.part(event.target) : nullptr;
        const bool linear = event.property == "Velocity";
        if (!part || !part->anchored || !event.vector || !isFinite(*event.vector)) continue;
        if (!linear && event.property != "RotVelocity") continue;
        const std::string reason = scriptReason(context.tree, reading, event.line);
        if (const auto known = first.find({part->id, event.property}); known != first.end()) {
          noteOthers(context, *part, known->second, *event.vector, reason, named);
          continue;
        }
        if (length(*event.vector) < kLeastSpeed) continue;
        first[{part->id, event.property}] = *event.vector;
        if (!linear)
          giveConveyor(*part, {{}, *event.vector}, reason, event.unsure);
        else if (isUpward(*event.vector))
          giveJumpPad(*part, {*event.vector, true}, reason, event.unsure);
        else
          giveConveyor(*part, {*event.vector, {}}, reason, event.unsure);
      }
    }
}

void conveyorFromVelocity(RoleContext& context) {
  for (PartDraft& part : context.level.parts) {
    const Instance& instance = context.tree.at(part.id);
    const auto velocity = get<Vec3>(instance, "Velocity");
    const auto angular = get<Vec3>(instance, "RotVelocity");
    const bool anchored = get<bool>(instance, "Anchored");
    if (!anchored || !isFinite(velocity) || !isFinite(angular)) continue;
    if (length(velocity) < kLeastSpeed && length(angular) < kLeastSpeed) continue;
    if (part.conveyor || part.jumpPad) continue;
    if (length(velocity) >= kLeastSpeed && !isAligned(part, velocity)) {
      context.level.noteIgnored("saved velocity along no axis", context.tree.path(part.id),
                                "taken as left over from physics, not as a conveyor");
      continue;
    }
    if (isUpward(velocity))
      giveJumpPad(part, {velocity, true}, "saved Velocity of an anchored part", true);
    else
      giveConveyor(part, {velocity, angular}, "saved Velocity of an anchored part", false);
  }
}

void noteUntoldVelocities(RoleContext& context) {
  std::set<InstanceId> named;
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      if (!timeline.byItself()) continue;
      for (const ScriptEvent& event : timeline.events) {
        const PartDraft* part = isUntold(event) ? context.part(event.target) : nullptr;
        if (!part || !part->anchored || !part->solid || isStated(*part)) continue;
        if (named.insert(part->id).second)
          noteUntold(context, *part, event, scriptReason(context.tree, reading, event.line));
      }
    }
}

}  // namespace obby::importer
