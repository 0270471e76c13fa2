// Ends of constraints, lines of sliders, and what their motors do.
#include "import/roles/driven.h"

#include <algorithm>
#include <cmath>

#include "import/format/class_defaults.h"
#include "import/pivot.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

// Where a script sets one of these, the file alone does not tell where a motor goes.
constexpr std::string_view kMotorProperties[] = {"ActuatorType", "Enabled",       "LimitsEnabled",
                                                 "LowerLimit",   "MotorMaxForce", "UpperLimit",
                                                 "Velocity"};

Pose attachmentFrame(const Tree& tree, const Instance& constraint, const char* name,
                     InstanceId part) {
  const auto* ref = property<Ref>(constraint, name);
  const Pose base = pivotOf(tree, part);
  if (!ref || ref->target >= tree.size()) return base;
  return base * get<CFrame>(tree.at(ref->target), "CFrame");
}

bool isScripted(const RoleContext& context, InstanceId motor) {
  const auto concerns = [&](const ScriptEvent& e) {
    return e.target == motor && std::find(std::begin(kMotorProperties), std::end(kMotorProperties),
                                          e.property) != std::end(kMotorProperties);
  };
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines)
      if (std::any_of(timeline.events.begin(), timeline.events.end(), concerns)) return true;
  return false;
}

// Why the way of a motor is not known; empty: it is.
std::string unknownWay(const RoleContext& context, InstanceId motor) {
  const Instance& slider = context.tree.at(motor);
  if (isScripted(context, motor)) return "a script sets what drives it";
  const bool goes = get<double>(slider, "Velocity") != 0;
  return goes && !get<bool>(slider, "LimitsEnabled") ? "no limit ends its way" : "";
}

bool toItsLimit(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin) {
  const Instance& slider = context.tree.at(drive.constraint);
  const double velocity = get<double>(slider, "Velocity");
  const double limit = get<double>(slider, velocity > 0 ? "UpperLimit" : "LowerLimit");
  const Track track = trackOf(context.tree, drive);
  if (velocity == 0 || !(std::abs(limit - track.now) >= kArrived)) return false;
  return giveDriven(context, drive.moving, slideTo(track, limit, std::abs(velocity), spin),
                    drive.constraint, "motor to its limit", false);
}

// Where the file has it; with a spin it turns there.
bool standStill(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin) {
  if (!spin) return hold(context, drive.moving, "a motor holds it in place");
  Motion motion;
  motion.spin = spin;
  return giveDriven(context, drive.moving, std::move(motion), drive.constraint, "motor", false);
}

}  // namespace

std::optional<Drive> driveOf(const RoleContext& context, InstanceId constraint) {
  const JointEnds ends = jointEnds(context.tree, constraint);
  if (ends.first == kNoInstance || ends.second == kNoInstance) return std::nullopt;
  const bool firstHeld = context.assemblies.anchored(ends.first);
  if (firstHeld == context.assemblies.anchored(ends.second)) return std::nullopt;
  Drive drive{constraint, firstHeld ? ends.second : ends.first, !firstHeld, {}};
  drive.frame = attachmentFrame(context.tree, context.tree.at(constraint),
                                firstHeld ? "Attachment0" : "Attachment1",
                                firstHeld ? ends.first : ends.second);
  return drive;
}

bool giveDriven(RoleContext& context, InstanceId moving, Motion motion, InstanceId constraint,
                const std::string& what, bool guessed) {
  motion.carries = true;
  const std::string reason = context.tree.at(constraint).className + " " + what;
  return giveMotion(context, moving, motion, reason, guessed) > 0;
}

bool hold(RoleContext& context, InstanceId part, const std::string& why) {
  bool any = false;
  for (InstanceId member : context.assemblies.members(part))
    if (PartDraft* draft = context.part(member); draft && !draft->anchored) {
      draft->anchored = true;
      draft->evidence.push_back({"held", why, true});
      any = true;
    }
  return any;
}

Track trackOf(const Tree& tree, const Drive& drive) {
  Track track;
  track.own = pivotOf(tree, drive.moving);
  track.axis = drive.frame.rotation.x * (drive.reversed ? -1.0f : 1.0f);
  const auto* ref =
      property<Ref>(tree.at(drive.constraint), drive.reversed ? "Attachment0" : "Attachment1");
  Vec3 attached = track.own.position;
  if (ref && ref->target < tree.size())
    attached = toWorld(track.own, get<CFrame>(tree.at(ref->target), "CFrame").position);
  track.now = double(dot(attached - drive.frame.position, track.axis));
  return track;
}

Motion slideTo(const Track& track, double position, double speed, const std::optional<Spin>& spin) {
  const double takes = std::abs(position - track.now) / speed;
  Motion motion;
  motion.repeat = Repeat::once;
  motion.spin = spin;
  motion.keys = {{0, track.own, Easing::linear, EasingDirection::out},
                 {float(takes), track.at(position), Easing::linear, EasingDirection::out}};
  return motion;
}

bool fromSliderMotor(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin) {
  const InstanceId motor = drive.constraint;
  if (!(get<double>(context.tree.at(motor), "MotorMaxForce") > 0)) return false;
  const std::string unknown = unknownWay(context, motor);
  if (unknown.empty() && toItsLimit(context, drive, spin)) return true;
  if (!standStill(context, drive, spin)) return false;
  if (!unknown.empty())
    context.level.noteUnmodelled("motion of a slider's motor", context.tree.path(motor),
                                 unknown + "; what it moves stays where the file has it");
  return true;
}

}  // namespace obby::importer
