// Finds parts that physics moves: hinges and sliders with a motor, and parts that movers push, pull
// and turn. They carry players. Constraints without a motion are noted as unmodelled.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/document/classes.h"
#include "import/document/pivot.h"
#include "import/roles/driven.h"
#include "import/roles/movers.h"
#include "import/roles/role.h"

namespace obby::importer {
namespace {

constexpr std::string_view kCylinder = "CylindricalConstraint";

// Returns how a motor turns the moving part.
std::optional<Spin> spinOf(const RoleContext& context, const ConstraintSettings& settings,
                           const Drive& drive) {
  const InstanceId hinge = drive.constraint;
  const bool cylinder = context.tree.at(hinge).className == kCylinder;
  const uint32_t actuator =
      settings.choice(hinge, cylinder ? "AngularActuatorType" : "ActuatorType");
  const double torque = settings.number(hinge, "MotorMaxTorque");
  const double speed = settings.number(hinge, "AngularVelocity");
  if (actuator != kMotor || !(torque > 0) || speed == 0) return std::nullopt;
  const Pose own = pivotOf(context.tree, drive.moving);
  return Spin{toLocal(own.rotation, drive.frame.rotation.x), float(drive.reversed ? -speed : speed),
              toLocal(own, drive.frame.position)};
}

constexpr const char* kHingeMotor = "motion of a hinge's motor";

bool fromHinge(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  const auto drive = driveOf(context, id);
  if (!drive) return false;
  Motion motion;
  motion.spin = spinOf(context, settings, *drive);
  if (motion.spin && settings.hasAngularLimits(id))
    return leaveDriven(context, kHingeMotor, drive->moving, id, "its limits stop the turn");
  return motion.spin && giveDriven(context, *drive, std::move(motion), "motor", false);
}

bool fromServo(RoleContext& context, const ConstraintSettings& settings, const Drive& drive,
               const std::optional<Spin>& spin) {
  const InstanceId servo = drive.constraint;
  const double speed = settings.number(servo, "Speed");
  if (!(speed > 0) || !(settings.number(servo, "ServoMaxForce") > 0)) return false;
  const Track track = trackOf(context.tree, drive);
  const double target = settings.number(servo, "TargetPosition");
  if (std::abs(target - track.now) < kArrived) return standStill(context, drive, spin);
  return giveDriven(context, drive, slideTo(track, target, speed, spin), "servo", false);
}

bool fromSlider(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  const auto drive = driveOf(context, id);
  if (!drive) return false;
  const uint32_t actuator = settings.choice(id, "ActuatorType");
  // A cylinder may turn as it slides.
  const bool turns = context.tree.at(id).className == kCylinder;
  const auto spin =
      turns && !settings.hasAngularLimits(id) ? spinOf(context, settings, *drive) : std::nullopt;
  return actuator == kMotor ? fromSliderMotor(context, settings, *drive, spin)
                            : actuator == kServo && fromServo(context, settings, *drive, spin);
}

// Returns the part of the level that the constraint leaves unanchored, or kNoInstance.
InstanceId dynamicPart(RoleContext& context, InstanceId id) {
  const JointEnds ends = jointEnds(context.tree, id);
  for (InstanceId end : {ends.first, ends.second, movedPart(context.tree, id)}) {
    const PartDraft* part = end == kNoInstance ? nullptr : context.part(end);
    if (part && !part->motion && !part->anchored) return end;
  }
  return kNoInstance;
}

bool understand(RoleContext& context, const ConstraintSettings& settings, const Pulls& pulls,
                InstanceId id) {
  const std::string& name = context.tree.at(id).className;
  if (name == "HingeConstraint") return fromHinge(context, settings, id);
  if (name == "PrismaticConstraint") return fromSlider(context, settings, id);
  if (name == kCylinder)
    return fromSlider(context, settings, id) || fromHinge(context, settings, id);
  return fromMover(context, settings, pulls, id);
}

// Notes a part that a script moves although it also has a motor. The motor has no effect.
void noteBoth(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  if (settings.choice(id, "ActuatorType") == 0 && settings.choice(id, "AngularActuatorType") == 0)
    return;
  const JointEnds ends = jointEnds(context.tree, id);
  for (const InstanceId end : {ends.first, ends.second}) {
    if (end == kNoInstance || context.assemblies.anchored(end)) continue;
    const PartDraft* part = context.part(end);
    if (part && part->motion && !part->motion->carries)
      context.level.noteUnmodelled(
          "part that a script and a constraint move", context.tree, end,
          "moved by the script only; the constraint " + context.tree.path(id) + " is ignored");
  }
}

// Gives motions to parts, and returns the constraints that move none. It takes several passes: a
// part attached to a moving part can only follow once that part has its motion.
std::vector<InstanceId> withoutMotion(RoleContext& context, const ConstraintSettings& settings) {
  constexpr int kLongestChain = 8;
  const Pulls pulls = pullsOf(context, settings);
  std::vector<InstanceId> open;
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    if (isFreeConstraintClass(context.tree.at(id).className) && settings.isEnabled(id))
      open.push_back(id);
  }
  std::stable_partition(open.begin(), open.end(),
                        [&](InstanceId id) { return !isPusher(context.tree.at(id).className); });
  for (int link = 0; link < kLongestChain; ++link) {
    std::vector<InstanceId> left;
    for (const InstanceId id : open)
      if (!understand(context, settings, pulls, id)) left.push_back(id);
    const bool done = left.size() == open.size();
    open = std::move(left);
    if (done) break;
  }
  return open;
}

}  // namespace

void movingFromConstraints(RoleContext& context) {
  const ConstraintSettings settings(context.tree);
  const std::vector<InstanceId> left = withoutMotion(context, settings);
  std::set<InstanceId> held;
  for (InstanceId id : left) {
    noteBoth(context, settings, id);
    noteTurning(context, settings, id);
    const InstanceId moved = dynamicPart(context, id);
    if (moved == kNoInstance) continue;  // moves nothing in the level
    const std::string& className = context.tree.at(id).className;
    context.level.noteUnmodelled(
        "constraint " + className, context.tree, id,
        isHolder(className) ? "not simulated; the part stays at its position in the file"
                            : "not simulated; the part that it holds or drives moves freely");
    if (isHolder(className)) held.insert(moved);
  }
  for (InstanceId id : held) hold(context, id, "a mover holds it in place");
}

}  // namespace obby::importer
