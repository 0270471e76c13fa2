// Parts that physics moves: hinges and sliders with a motor, positions that a script steps, legacy
// body movers. They carry who stands on them. What is left over is named as unmodelled.
#include <algorithm>
#include <cmath>
#include <set>

#include "import/classes.h"
#include "import/format/class_defaults.h"
#include "import/pivot.h"
#include "import/roles/driven.h"

namespace obby::importer {
namespace {

constexpr std::string_view kCylinder = "CylindricalConstraint";
constexpr double kAlignSeconds = 0.5;  // an AlignPosition or BodyPosition without a speed limit

// How a motor turns the moving part.
std::optional<Spin> spinOf(const RoleContext& context, const Drive& drive) {
  const Instance& hinge = context.tree.at(drive.constraint);
  const bool cylinder = hinge.className == kCylinder;
  const auto actuator =
      propertyOr(hinge, cylinder ? "AngularActuatorType" : "ActuatorType", EnumItem{});
  const double torque = propertyOr(hinge, "MotorMaxTorque", 0.0);
  const double speed = propertyOr(hinge, "AngularVelocity", 0.0);
  if (actuator.value != kMotor || !(torque > 0) || speed == 0) return std::nullopt;
  const Pose own = pivotOf(context.tree, drive.moving);
  return Spin{toLocal(own.rotation, drive.frame.rotation.x), float(drive.reversed ? -speed : speed),
              toLocal(own, drive.frame.position)};
}

bool fromHinge(RoleContext& context, InstanceId id) {
  const auto drive = driveOf(context, id);
  if (!drive) return false;
  Motion motion;
  motion.spin = spinOf(context, *drive);
  return motion.spin && giveDriven(context, drive->moving, std::move(motion), id, "motor", false);
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
Motion stepped(const std::vector<std::pair<double, Pose>>& goals, const Steps& steps,
               double speed) {
  Motion motion;
  beginAt(motion, steps.start);
  Pose last = goals.back().second;
  const auto add = [&](double time, const Pose& pose) {
    const double at = motion.keys.empty() ? 0 : std::max(time, double(motion.keys.back().time));
    motion.keys.push_back({float(at), pose, Easing::linear, EasingDirection::out});
  };
  add(0, last);
  for (size_t i = 0; i < goals.size(); ++i) {
    const double until = i + 1 < goals.size() ? goals[i + 1].first : steps.period;
    const double way = double(length(goals[i].second.position - last.position));
    const double takes = speed > 0 ? way / speed : kAlignSeconds;
    add(goals[i].first, last);
    add(std::min(goals[i].first + takes, until), goals[i].second);
    last = goals[i].second;
  }
  add(steps.period, last);
  return motion;
}

bool fromServo(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin) {
  const Instance& slider = context.tree.at(drive.constraint);
  const double speed = propertyOr(slider, "Speed", 0.0);
  if (!(speed > 0)) return false;
  const Track track = trackOf(context.tree, drive);
  if (const auto steps = stepsOf(context, drive.constraint, {"TargetPosition"})) {
    std::vector<std::pair<double, Pose>> goals;
    for (const ScriptEvent* e : steps->events)
      if (e->number) goals.emplace_back(e->time - steps->start, track.at(*e->number));
    if (!goals.empty()) {
      Motion motion = stepped(goals, *steps, speed);
      motion.spin = spin;
      return giveDriven(context, drive.moving, std::move(motion), drive.constraint,
                        "servo stepped by a script", false);
    }
  }
  const double target = get<double>(slider, "TargetPosition");
  if (std::abs(target - track.now) < kArrived) return false;
  return giveDriven(context, drive.moving, slideTo(track, target, speed, spin), drive.constraint,
                    "servo", false);
}

bool fromSlider(RoleContext& context, InstanceId id) {
  const auto drive = driveOf(context, id);
  if (!drive) return false;
  const Instance& slider = context.tree.at(id);
  const uint32_t actuator = propertyOr(slider, "ActuatorType", EnumItem{}).value;
  // A cylinder may turn as it slides.
  const auto spin = slider.className == kCylinder ? spinOf(context, *drive) : std::nullopt;
  if (actuator == kMotor) return fromSliderMotor(context, *drive, spin);
  return actuator == kServo && fromServo(context, *drive, spin);
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
  return giveDriven(context, part, stepped(goals, *steps, std::isfinite(limit) ? limit : 0), id,
                    "stepped by a script", true);
}

// A vector of a body mover, a number of a constraint.
bool hasTorque(const Instance& mover) {
  return get<double>(mover, "MaxTorque") > 0 || length(get<Vec3>(mover, "MaxTorque")) > 0;
}

bool fromTurner(RoleContext& context, InstanceId id) {
  const InstanceId part = movedPart(context.tree, id);
  const Instance& mover = context.tree.at(id);
  const Vec3 turn = get<Vec3>(mover, "AngularVelocity");
  if (part == kNoInstance || length(turn) < 1e-3f || !hasTorque(mover) ||
      context.assemblies.anchored(part))
    return false;
  Motion motion;
  motion.spin =
      Spin{toLocal(pivotOf(context.tree, part).rotation, normalize(turn)), length(turn), {}};
  return giveDriven(context, part, motion, id, "turns it", true);
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
  if (name == "HingeConstraint") return fromHinge(context, id);
  if (name == "PrismaticConstraint") return fromSlider(context, id);
  if (name == kCylinder) return fromSlider(context, id) || fromHinge(context, id);
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
  for (InstanceId id : held) hold(context, id, "a mover holds it in place");
}

}  // namespace obby::importer
