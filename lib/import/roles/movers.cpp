// Computes motions from the values in the file. A part's time to reach its velocity is ignored.
// Movers that scripts set in play are simulated by the twin of the engine (observed/moving.cpp).
#include "import/roles/movers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/document/classes.h"
#include "import/document/pivot.h"
#include "import/document/pose_math.h"

namespace obby::importer {
namespace {

// Classes that only turn a part. They do not affect its position.
constexpr std::string_view kOnlyTurn[] = {
    "AlignOrientation", "AngularVelocity", "BodyAngularVelocity",  "BodyGyro", "Torque", "Rotate",
    "RotateP",          "RotateV",         "NoCollisionConstraint"};
constexpr uint32_t kOfFirst = 0, kOfSecond = 1, kOfWorld = 2;  // ActuatorRelativeTo
constexpr uint32_t kVector = 2;                                // VelocityConstraintMode
constexpr uint32_t kTwoAttachments = 1;                        // PositionAlignmentMode

// Returns the weight in rowtons, an upper bound: shapes count as their boxes.
double weightOf(RoleContext& context, InstanceId part) {
  double mass = 0;
  for (const InstanceId member : context.assemblies.members(part))
    if (const PartDraft* draft = context.part(member))
      mass += double(draft->size.x) * double(draft->size.y) * double(draft->size.z) *
              double(draft->density);
  return mass * double(context.level.world.gravity);
}

// Returns the max force of a mover along each axis of the world, or nullopt if the force is limited
// in another frame.
std::optional<Vec3> forceOf(const Tree& tree, const ConstraintSettings& settings, InstanceId id) {
  if (tree.at(id).className == "BodyVelocity") return settings.vector(id, "MaxForce");
  if (settings.choice(id, "VelocityConstraintMode") != kVector ||
      settings.choice(id, "RelativeTo") != kOfWorld || settings.choice(id, "ForceLimitMode") != 0)
    return std::nullopt;
  const bool limited = propertyOr(tree.at(id), "ForceLimitsEnabled", true);
  const float force = limited ? float(settings.number(id, "MaxForce")) : INFINITY;
  return Vec3{force, force, force};
}

// Returns 1 for each axis along which the force pushes the part, else 0. Returns nullopt if the
// force cannot lift the part, or drags it slowly.
std::optional<Vec3> axesOf(Vec3 force, double weight) {
  Vec3 axes = {1, 1, 1};
  for (const auto& [of, axis] : {std::pair(force.x, &axes.x), std::pair(force.z, &axes.z)}) {
    if (of > 0 && double(of) < weight) return std::nullopt;
    if (!(of > 0)) *axis = 0;
  }
  if (!(double(force.y) >= weight && force.y > 0)) return std::nullopt;
  return axes;
}

const char* velocityName(const Tree& tree, InstanceId id) {
  return tree.at(id).className == "BodyVelocity" ? "Velocity" : "VectorVelocity";
}

bool fromPusher(RoleContext& context, const ConstraintSettings& settings, const Pulls& pulls,
                InstanceId id) {
  const InstanceId part = movedPart(context.tree, id);
  if (part == kNoInstance || !isFree(context, part)) return false;
  if (const auto all = pulls.find(part); all != pulls.end() && all->second > 1) return false;
  const auto force = forceOf(context.tree, settings, id);
  const auto axes = force ? axesOf(*force, weightOf(context, part)) : std::nullopt;
  if (!axes) return false;
  constexpr const char* kKind = "motion by a BodyVelocity or LinearVelocity";
  const char* const name = velocityName(context.tree, id);
  if (!(length(mul(settings.vector(id, name), *axes)) < 1e-3f))
    return leaveDriven(context, kKind, part, id, "nothing stops the motion");
  return hold(context, part, "a mover holds it in place");
}

// Returns the angular velocity of a mover in world space, in radians per second, at the poses of
// the file. Returns zero if the mover turns nothing.
Vec3 turnBy(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  const Instance& mover = context.tree.at(id);
  Vec3 turn = settings.vector(id, "AngularVelocity");
  if (mover.className == "BodyAngularVelocity") {
    const Vec3 torque = settings.vector(id, "MaxTorque");
    return {torque.x > 0 ? turn.x : 0, torque.y > 0 ? turn.y : 0, torque.z > 0 ? turn.z : 0};
  }
  if (!(settings.number(id, "MaxTorque") > 0)) return {};
  const JointEnds ends = jointEnds(context.tree, id);
  const uint32_t frame = settings.choice(id, "RelativeTo");
  if (frame == kOfFirst && ends.first != kNoInstance)
    return attachmentFrame(context.tree, mover, "Attachment0", ends.first).rotation * turn;
  if (frame == kOfSecond && ends.second != kNoInstance)
    return attachmentFrame(context.tree, mover, "Attachment1", ends.second).rotation * turn;
  return turn;
}

bool fromTurner(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  const InstanceId part = movedPart(context.tree, id);
  if (part == kNoInstance || !isFree(context, part)) return false;
  const Vec3 turn = turnBy(context, settings, id);
  if (!(length(turn) >= 1e-3f)) return false;
  Motion motion;
  motion.spin =
      Spin{toLocal(pivotOf(context.tree, part).rotation, normalize(turn)), length(turn), {}};
  return giveDriven(context, part, motion, id, "turns the part", true);
}

// Returns the pulls summed over joined parts.
Pulls summed(const Assemblies& assemblies, const Pulls& pulls) {
  Pulls sums;
  for (const auto& [part, own] : pulls) {
    if (sums.count(part) > 0) continue;
    const std::vector<InstanceId> members = assemblies.members(part);
    int sum = 0;
    for (const InstanceId member : members)
      if (const auto known = pulls.find(member); known != pulls.end()) sum += known->second;
    for (const InstanceId member : members)
      if (pulls.count(member) > 0) sums[member] = sum;
  }
  return sums;
}

// Moves a part along with the moving part that it is aligned to.
bool fromFollower(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  if (settings.choice(id, "Mode") != kTwoAttachments) return false;
  const auto drive = driveOf(context, id);
  if (!drive || !drive->reversed || !baseMoves(context, *drive)) return false;
  const Motion& baseMotion = *context.part(drive->base)->motion;
  const bool turns =
      std::any_of(baseMotion.keys.begin(), baseMotion.keys.end(), [&](const MotionKey& key) {
        return !samePose({{}, key.pose.rotation}, {{}, baseMotion.keys.front().pose.rotation});
      });
  const Pose own = attachmentFrame(context.tree, context.tree.at(id), "Attachment0", drive->moving);
  constexpr float kNear = 1;  // max studs between the attachments
  if (baseMotion.spin || turns || !(length(own.position - drive->frame.position) <= kNear))
    return false;
  return giveDriven(context, *drive, Motion{}, "makes the part follow a moving part", true);
}

}  // namespace

Pulls pullsOf(RoleContext& context, const ConstraintSettings& settings) {
  Pulls pulls;
  for (InstanceId id = 0; id < context.tree.size(); ++id) {
    const std::string& name = context.tree.at(id).className;
    const bool turns =
        std::find(std::begin(kOnlyTurn), std::end(kOnlyTurn), name) != std::end(kOnlyTurn);
    if (!isFreeConstraintClass(name) || turns || !settings.isEnabled(id)) continue;
    const JointEnds ends = jointEnds(context.tree, id);
    if (ends.second != kNoInstance) ++pulls[ends.second];
    if (const InstanceId part = movedPart(context.tree, id); part != kNoInstance) ++pulls[part];
  }
  return summed(context.assemblies, pulls);
}

bool fromMover(RoleContext& context, const ConstraintSettings& settings, const Pulls& pulls,
               InstanceId id) {
  const std::string& name = context.tree.at(id).className;
  if (name == "BodyAngularVelocity" || name == "AngularVelocity")
    return fromTurner(context, settings, id);
  if (isPusher(name)) return fromPusher(context, settings, pulls, id);
  return name == "AlignPosition" && fromFollower(context, settings, id);
}

void noteTurning(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  if (!isPusher(context.tree.at(id).className)) return;
  const InstanceId part = movedPart(context.tree, id);
  const PartDraft* draft = part == kNoInstance ? nullptr : context.part(part);
  if (!draft || !draft->motion || !draft->motion->spin || !draft->motion->carries) return;
  const auto force = forceOf(context.tree, settings, id);
  const char* const name = velocityName(context.tree, id);
  if (length(settings.vector(id, name)) >= 1e-3f && (!force || length(*force) > 0))
    context.level.noteUnmodelled(
        "part that two movers move", context.tree, part,
        "simulated as turning in place; ignored: " + context.tree.path(id));
}

bool isPusher(const std::string& className) {
  return className == "BodyVelocity" || className == "LinearVelocity";
}

bool isHolder(const std::string& className) {
  return className == "BodyPosition" || className == "AlignPosition";
}

}  // namespace obby::importer
