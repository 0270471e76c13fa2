// Parts that physics moves: hinges and sliders with a motor, positions that a script steps, legacy
// body movers. They carry who stands on them. What is left over is named as unmodelled.
#include <algorithm>
#include <cmath>
#include <set>

#include "import/classes.h"
#include "import/format/class_defaults.h"
#include "import/motion.h"
#include "import/pivot.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr uint32_t kMotor = 1, kServo = 2;
constexpr double kAlignSeconds = 0.5;  // an AlignPosition or BodyPosition without a speed limit

struct Drive {
  InstanceId constraint = kNoInstance;
  InstanceId moving = kNoInstance;  // the part that is not held
  bool reversed = false;            // the moving part is the first end
  Pose frame;                       // world frame of the fixed attachment
};

Pose attachmentFrame(const Tree& tree, const Instance& constraint, const char* name,
                     InstanceId part) {
  const auto* ref = property<Ref>(constraint, name);
  const Pose base = pivotOf(tree, part);
  if (!ref || ref->target >= tree.size()) return base;
  return base * get<CFrame>(tree.at(ref->target), "CFrame");
}

// The end that moves, if exactly one end is held.
std::optional<Drive> driveOf(RoleContext& context, InstanceId id) {
  const JointEnds ends = jointEnds(context.tree, id);
  if (ends.first == kNoInstance || ends.second == kNoInstance) return std::nullopt;
  const bool firstHeld = context.assemblies.anchored(ends.first);
  if (firstHeld == context.assemblies.anchored(ends.second)) return std::nullopt;
  const Instance& constraint = context.tree.at(id);
  Drive drive{id, firstHeld ? ends.second : ends.first, !firstHeld, {}};
  drive.frame = attachmentFrame(context.tree, constraint, firstHeld ? "Attachment0" : "Attachment1",
                                firstHeld ? ends.first : ends.second);
  return drive;
}

bool give(RoleContext& context, InstanceId moving, Motion motion, InstanceId constraint,
          const std::string& what, bool guessed) {
  motion.carries = true;
  const std::string reason = context.tree.at(constraint).className + " " + what;
  return giveMotion(context, moving, motion, reason, guessed) > 0;
}

Motion turning(const RoleContext& context, InstanceId moving, const Pose& about, double speed) {
  const Pose own = pivotOf(context.tree, moving);
  Motion motion;
  motion.spin =
      Spin{toLocal(own.rotation, about.rotation.x), float(speed), toLocal(own, about.position)};
  return motion;
}

bool fromHinge(RoleContext& context, InstanceId id) {
  const Instance& hinge = context.tree.at(id);
  const bool cylinder = hinge.className == "CylindricalConstraint";
  const auto actuator =
      propertyOr(hinge, cylinder ? "AngularActuatorType" : "ActuatorType", EnumItem{});
  const double torque = propertyOr(hinge, "MotorMaxTorque", 0.0);
  const double speed = propertyOr(hinge, "AngularVelocity", 0.0);
  const auto drive = driveOf(context, id);
  if (!drive || actuator.value != kMotor || !(torque > 0) || speed == 0) return false;
  return give(context, drive->moving,
              turning(context, drive->moving, drive->frame, drive->reversed ? -speed : speed), id,
              "motor", false);
}

// Steps that a script's endless loop sets on a property of the constraint.
struct Steps {
  std::vector<const ScriptEvent*> events;
  double start = 0, period = 0;
};
std::optional<Steps> stepsOf(const RoleContext& context, InstanceId id,
                             std::initializer_list<const char*> names) {
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines) {
      if (!timeline.forever || !(timeline.period > 0)) continue;
      Steps steps{{}, timeline.loopStart, timeline.period};
      for (size_t i = timeline.loopEvent; i < timeline.events.size(); ++i) {
        const ScriptEvent& e = timeline.events[i];
        for (const char* name : names)
          if (e.target == id && e.property == name) steps.events.push_back(&e);
      }
      if (!steps.events.empty()) return steps;
    }
  return std::nullopt;
}

// From each goal to the next at `speed` (0: kAlignSeconds), waiting in between as the steps do.
Motion stepped(const std::vector<std::pair<double, Pose>>& goals, double period, double speed) {
  Motion motion;
  Pose last = goals.back().second;
  const auto add = [&](double time, const Pose& pose) {
    const double at = motion.keys.empty() ? 0 : std::max(time, double(motion.keys.back().time));
    motion.keys.push_back({float(at), pose, Easing::linear, EasingDirection::out});
  };
  add(0, last);
  for (size_t i = 0; i < goals.size(); ++i) {
    const double until = i + 1 < goals.size() ? goals[i + 1].first : period;
    const double way = double(length(goals[i].second.position - last.position));
    const double takes = speed > 0 ? way / speed : kAlignSeconds;
    add(goals[i].first, last);
    add(std::min(goals[i].first + takes, until), goals[i].second);
    last = goals[i].second;
  }
  add(period, last);
  return motion;
}

bool fromSlider(RoleContext& context, InstanceId id) {
  const Instance& slider = context.tree.at(id);
  const auto drive = driveOf(context, id);
  if (!drive || propertyOr(slider, "ActuatorType", EnumItem{}).value != kServo) return false;
  const double speed = propertyOr(slider, "Speed", 0.0);
  const Pose own = pivotOf(context.tree, drive->moving);
  const Vec3 axis = drive->frame.rotation.x * (drive->reversed ? -1.0f : 1.0f);
  const auto* ref = property<Ref>(slider, drive->reversed ? "Attachment0" : "Attachment1");
  const Vec3 attached =
      ref && ref->target < context.tree.size()
          ? toWorld(own, get<CFrame>(context.tree.at(ref->target), "CFrame").position)
          : own.position;
  const double now = double(dot(attached - drive->frame.position, axis));
  const auto at = [&](double target) {
    return Pose{own.position + axis * float(target - now), own.rotation};
  };
  if (const auto steps = stepsOf(context, id, {"TargetPosition"})) {
    std::vector<std::pair<double, Pose>> goals;
    for (const ScriptEvent* e : steps->events)
      if (e->number) goals.emplace_back(e->time - steps->start, at(*e->number));
    if (!goals.empty() && speed > 0)
      return give(context, drive->moving, stepped(goals, steps->period, speed), id,
                  "servo stepped by a script", false);
  }
  const double target = propertyOr(slider, "TargetPosition", now);
  if (!(speed > 0) || std::abs(target - now) < 0.05) return false;
  Motion motion;
  motion.repeat = Repeat::once;
  motion.keys = {
      {0, own, Easing::linear, EasingDirection::out},
      {float(std::abs(target - now) / speed), at(target), Easing::linear, EasingDirection::out}};
  return give(context, drive->moving, motion, id, "servo", false);
}

// The part that a mover in OneAttachment mode or a legacy body mover acts on.
InstanceId movedPart(const Tree& tree, InstanceId id) {
  const JointEnds ends = jointEnds(tree, id);
  if (ends.first != kNoInstance) return ends.first;
  InstanceId up = tree.at(id).parent;
  while (up != kNoInstance && !tree.isPart(up)) up = tree.at(up).parent;
  return up;
}

bool fromPosition(RoleContext& context, InstanceId id) {
  const InstanceId part = movedPart(context.tree, id);
  if (part == kNoInstance) return false;
  const auto steps = stepsOf(context, id, {"Position", "position"});
  if (!steps) return false;
  const Pose own = pivotOf(context.tree, part);
  std::vector<std::pair<double, Pose>> goals;
  for (const ScriptEvent* e : steps->events)
    if (e->vector) goals.emplace_back(e->time - steps->start, Pose{*e->vector, own.rotation});
  if (goals.empty()) return false;
  const double limit = propertyOr(context.tree.at(id), "MaxVelocity", 0.0);
  return give(context, part, stepped(goals, steps->period, std::isfinite(limit) ? limit : 0), id,
              "stepped by a script", true);
}

bool fromTurner(RoleContext& context, InstanceId id) {
  const InstanceId part = movedPart(context.tree, id);
  const Instance& mover = context.tree.at(id);
  Vec3 turn = propertyOr(mover, "AngularVelocity", Vec3{});
  if (length(turn) < 1e-3f) turn = propertyOr(mover, "angularvelocity", Vec3{});
  if (part == kNoInstance || length(turn) < 1e-3f || context.assemblies.anchored(part))
    return false;
  Motion motion;
  motion.spin =
      Spin{toLocal(pivotOf(context.tree, part).rotation, normalize(turn)), length(turn), {}};
  return give(context, part, motion, id, "turns it", true);
}

// The part of the level that the constraint leaves loose; kNoInstance if there is none.
InstanceId loosePart(RoleContext& context, InstanceId id) {
  const JointEnds ends = jointEnds(context.tree, id);
  for (InstanceId end : {ends.first, ends.second, movedPart(context.tree, id)}) {
    const PartDraft* part = end == kNoInstance ? nullptr : context.part(end);
    if (part && !part->motion && !part->anchored) return end;
  }
  return kNoInstance;
}

// A body that a mover holds in place and nothing steps.
bool isHolder(const std::string& className) {
  return className == "BodyPosition" || className == "AlignPosition";
}

bool understand(RoleContext& context, InstanceId id) {
  const std::string& name = context.tree.at(id).className;
  if (name == "HingeConstraint" || name == "CylindricalConstraint") return fromHinge(context, id);
  if (name == "PrismaticConstraint") return fromSlider(context, id);
  if (name == "BodyAngularVelocity" || name == "AngularVelocity") return fromTurner(context, id);
  return isHolder(name) && fromPosition(context, id);
}

}  // namespace

void movingFromConstraints(RoleContext& context) {
  std::vector<InstanceId> left;
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const Instance& constraint = context.tree.at(id);
    if (isFreeConstraintClass(constraint.className) && propertyOr(constraint, "Enabled", true) &&
        !understand(context, id))
      left.push_back(id);
  }
  std::set<InstanceId> held;
  for (InstanceId id : left) {
    const InstanceId moved = loosePart(context, id);
    if (moved == kNoInstance) continue;  // moves nothing in the level
    const std::string& className = context.tree.at(id).className;
    context.level.noteUnmodelled("constraint " + className, context.tree.path(id),
                                 isHolder(className) ? "the part stays where the file has it"
                                                     : "what it holds or drives is a loose body");
    if (isHolder(className)) held.insert(moved);
  }
  for (InstanceId id : held)
    for (InstanceId member : context.assemblies.members(id))
      if (PartDraft* part = context.part(member); part && !part->anchored) {
        part->anchored = true;
        part->evidence.push_back({"held", "a mover holds it in place", true});
      }
}

}  // namespace obby::importer
