// Computes the ends of constraints, the lines of sliders and the effects of their motors.
#include "import/roles/driven.h"

#include <cmath>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/document/pivot.h"
#include "import/document/pose_math.h"

namespace obby::importer {
namespace {

// Returns why it is unknown where a slider's motor takes its part, or "" if it is known.
std::string unknownDirection(RoleContext& context, const ConstraintSettings& settings,
                             const Drive& drive) {
  const InstanceId motor = drive.constraint;
  if (settings.number(motor, "Velocity") == 0) return "";
  if (!settings.hasLimits(motor)) return "no limit stops the motion";
  return baseMoves(context, drive) ? "the part that carries the slider moves, too" : "";
}

bool toItsLimit(RoleContext& context, const ConstraintSettings& settings, const Drive& drive,
                const std::optional<Spin>& spin) {
  const double velocity = settings.number(drive.constraint, "Velocity");
  const char* const end = velocity > 0 ? "UpperLimit" : "LowerLimit";
  const double limit = settings.number(drive.constraint, end);
  const Track track = trackOf(context.tree, drive);
  if (velocity == 0 || !(std::abs(limit - track.now) >= kArrived)) return false;
  return giveDriven(context, drive, slideTo(track, limit, std::abs(velocity), spin),
                    "motor drives the part to its limit", false);
}

// Returns the motion of a part that is attached to `base` and moves along with it, or nullopt if
// the two motions cannot be combined.
std::optional<Motion> carried(const PartDraft* base, const Pose& own, Motion motion) {
  if (!base || !base->motion) return motion;
  const Pose back = inverse(base->pose);
  const Pose fromBase = back * (motion.keys.empty() ? own : motion.keys.front().pose);
  Motion baseMotion = withArcs(*base->motion, length(fromBase.position));
  if (baseMotion.spin || baseMotion.keys.empty() || motion.keys.size() > 1) return std::nullopt;
  motion.keys = std::move(baseMotion.keys);
  for (MotionKey& key : motion.keys) key.pose = key.pose * fromBase;
  motion.repeat = baseMotion.repeat;
  motion.offset = baseMotion.offset;
  return motion;
}

}  // namespace

InstanceId movedPart(const Tree& tree, InstanceId id) {
  const JointEnds ends = jointEnds(tree, id);
  if (ends.first != kNoInstance) return ends.first;
  InstanceId up = tree.at(id).parent;
  while (up != kNoInstance && !tree.isPart(up)) up = tree.at(up).parent;
  return up;
}

Pose attachmentFrame(const Tree& tree, const Instance& constraint, const char* name,
                     InstanceId part) {
  const auto* ref = property<Ref>(constraint, name);
  const Pose base = pivotOf(tree, part);
  if (!ref || ref->target >= tree.size()) return base;
  return base * get<CFrame>(tree.at(ref->target), "CFrame");
}

bool isFree(RoleContext& context, InstanceId part) {
  const PartDraft* draft = context.part(part);
  return draft ? !draft->anchored && !draft->motion : !context.assemblies.anchored(part);
}

std::optional<Drive> driveOf(RoleContext& context, InstanceId constraint) {
  const JointEnds ends = jointEnds(context.tree, constraint);
  if (ends.first == kNoInstance || ends.second == kNoInstance) return std::nullopt;
  const bool firstHeld = !isFree(context, ends.first);
  if (firstHeld != isFree(context, ends.second)) return std::nullopt;
  Drive drive;
  drive.constraint = constraint;
  drive.base = firstHeld ? ends.first : ends.second;
  drive.moving = firstHeld ? ends.second : ends.first;
  drive.reversed = !firstHeld;
  drive.frame = attachmentFrame(context.tree, context.tree.at(constraint),
                                firstHeld ? "Attachment0" : "Attachment1", drive.base);
  return drive;
}

bool baseMoves(RoleContext& context, const Drive& drive) {
  const PartDraft* base = context.part(drive.base);
  return base && base->motion;
}

bool giveDriven(RoleContext& context, InstanceId moving, Motion motion, InstanceId constraint,
                const std::string& what, bool guessed) {
  motion.carries = true;
  const std::string reason = context.tree.at(constraint).className + " " + what;
  return giveMotion(context, moving, motion, reason, guessed) > 0;
}

bool giveDriven(RoleContext& context, const Drive& drive, Motion motion, const std::string& what,
                bool guessed) {
  const Pose own = pivotOf(context.tree, drive.moving);
  auto combined = carried(context.part(drive.base), own, std::move(motion));
  if (combined)
    return giveDriven(context, drive.moving, std::move(*combined), drive.constraint, what, guessed);
  if (!hold(context, drive.moving, "it is attached to a moving part")) return false;
  context.level.noteUnmodelled(
      "motion on a moving part", context.tree, drive.constraint,
      "the driven part is attached to a moving part, and the two motions cannot be combined; "
      "the driven part stays at its position in the file");
  return true;
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

bool leaveDriven(RoleContext& context, const char* kind, InstanceId part, InstanceId constraint,
                 const std::string& why) {
  if (!hold(context, part, "the end of its motor-driven motion is unknown")) return false;
  context.level.noteUnmodelled(kind, context.tree, constraint,
                               "the driven part stays at its position in the file; " + why);
  return true;
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

bool standStill(RoleContext& context, const Drive& drive, const std::optional<Spin>& spin) {
  const PartDraft* base = context.part(drive.base);
  const bool stays = !base || !base->motion;
  if (!spin && stays) return hold(context, drive.moving, "a motor holds it in place");
  Motion motion;
  motion.spin = spin;
  return giveDriven(context, drive, std::move(motion), spin ? "motor" : "holds the part in place",
                    false);
}

bool fromSliderMotor(RoleContext& context, const ConstraintSettings& settings, const Drive& drive,
                     const std::optional<Spin>& spin) {
  const InstanceId motor = drive.constraint;
  if (!(settings.number(motor, "MotorMaxForce") > 0)) return false;
  const std::string unknown = unknownDirection(context, settings, drive);
  if (unknown.empty() && toItsLimit(context, settings, drive, spin)) return true;
  if (!standStill(context, drive, spin)) return false;
  if (!unknown.empty())
    context.level.noteUnmodelled("motion of a slider's motor", context.tree, motor,
                                 unknown + "; the driven part stays at its position in the file");
  return true;
}

}  // namespace obby::importer
