// Times and ways follow from what the file and the scripts state; that a part needs some time to
// come to its velocity is left out.
#include "import/roles/movers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "engine/classes/class_defaults.h"
#include "import/classes.h"
#include "import/pivot.h"
#include "import/pose_math.h"
#include "import/roles/stepped.h"
#include "import/tween_motion.h"

namespace obby::importer {
namespace {

// Of these a part may have any number and still go where something else takes it.
constexpr std::string_view kOnlyTurn[] = {
    "AlignOrientation", "AngularVelocity", "BodyAngularVelocity",  "BodyGyro", "Torque", "Rotate",
    "RotateP",          "RotateV",         "NoCollisionConstraint"};
constexpr std::string_view kPushProperties[] = {
    "Enabled",    "ForceLimitMode",         "MaxForce",       "ForceLimitsEnabled",
    "RelativeTo", "VelocityConstraintMode", "VectorVelocity", "Velocity"};
constexpr uint32_t kOfFirst = 0, kOfSecond = 1, kOfWorld = 2;  // ActuatorRelativeTo
constexpr uint32_t kVector = 2;                                // VelocityConstraintMode
constexpr uint32_t kTwoAttachments = 1;                        // PositionAlignmentMode

// Rowtons, at most: shapes are taken as their boxes.
double weightOf(RoleContext& context, InstanceId part) {
  double mass = 0;
  for (const InstanceId member : context.assemblies.members(part))
    if (const PartDraft* draft = context.part(member))
      mass += double(draft->size.x) * double(draft->size.y) * double(draft->size.z) *
              double(draft->density);
  return mass * double(context.level.world.gravity);
}

// The force of a mover that pushes along each axis of the world; nothing where it is not that
// simple.
std::optional<Vec3> forceOf(const Tree& tree, const ConstraintSettings& settings, InstanceId id) {
  if (tree.at(id).className == "BodyVelocity") return settings.vector(id, "MaxForce");
  if (settings.choice(id, "VelocityConstraintMode") != kVector ||
      settings.choice(id, "RelativeTo") != kOfWorld || settings.choice(id, "ForceLimitMode") != 0)
    return std::nullopt;
  const bool limited = propertyOr(tree.at(id), "ForceLimitsEnabled", true);
  const float force = limited ? float(settings.number(id, "MaxForce")) : INFINITY;
  return Vec3{force, force, force};
}

// Which axes it pushes along: 1, or 0 where it leaves the part alone. Nothing where it can not bear
// the part, or drags it along slowly.
std::optional<Vec3> axesOf(Vec3 force, double weight) {
  Vec3 axes = {1, 1, 1};
  for (const auto& [of, axis] : {std::pair(force.x, &axes.x), std::pair(force.z, &axes.z)}) {
    if (of > 0 && double(of) < weight) return std::nullopt;
    if (!(of > 0)) *axis = 0;
  }
  if (!(double(force.y) >= weight && force.y > 0)) return std::nullopt;
  return axes;
}

// The way of a part whose velocity a loop sets, from `own` on; nothing where a round does not end
// where it began, or the text does not tell.
std::optional<Motion> toAndFro(const Pose& own, const Steps& steps, Vec3 axes) {
  Motion motion;
  beginAt(motion, steps.start);
  Pose at = own;
  const auto add = [&](double time) {
    motion.keys.push_back({float(time), at, Easing::linear, EasingDirection::out});
  };
  add(0);
  for (size_t i = 0; i < steps.events.size(); ++i) {
    const ScriptEvent& e = *steps.events[i];
    const bool known = e.kind == EventKind::set && !e.unsure && e.vector && isFinite(*e.vector);
    if (!known) return std::nullopt;
    const bool last = i + 1 == steps.events.size();
    const double end = last ? steps.period : steps.events[i + 1]->time - steps.start;
    at.position += mul(*e.vector, axes) * float(end - (e.time - steps.start));
    add(end);
  }
  if (!(length(at.position - own.position) <= float(kArrived))) return std::nullopt;
  motion.keys.back().pose = own;
  return motion;
}

bool staysIn(const Motion& motion, Vec3 place) {
  return std::all_of(motion.keys.begin(), motion.keys.end(), [&](const MotionKey& key) {
    return length(key.pose.position - place) <= float(kArrived);
  });
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
  constexpr const char* kKind = "motion of a pushing mover";
  const char* const name = velocityName(context.tree, id);
  const PartDraft* draft = context.part(part);  // scripts may have placed it
  const Pose own = draft ? draft->pose : pivotOf(context.tree, part);
  if (const auto steps = stepsOf(context, id, {name})) {
    auto motion = toAndFro(own, *steps, *axes);
    if (!motion)
      return leaveDriven(context, kKind, part, id, "a round does not end where it began");
    if (!staysIn(*motion, own.position))
      return giveDriven(context, part, std::move(*motion), id, "reversed by a script", true);
  } else if (const auto change = settings.changeByItself(id, kPushProperties)) {
    return leaveDriven(context, kKind, part, id, setBy(*change));
  } else if (!(length(mul(settings.vector(id, name), *axes)) < 1e-3f)) {
    return leaveDriven(context, kKind, part, id, "nothing stops it");
  }
  return hold(context, part, "a mover holds it in place");
}

// The axis and speed of a mover that turns, in the world of the file; zero if it turns nothing.
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
  constexpr std::string_view kProperties[] = {"AngularVelocity", "MaxTorque"};
  if (const auto change = settings.changeByItself(id, kProperties))
    return leaveDriven(context, "motion of a turning mover", part, id, setBy(*change));
  const Vec3 turn = turnBy(context, settings, id);
  if (!(length(turn) >= 1e-3f)) return false;
  Motion motion;
  motion.spin =
      Spin{toLocal(pivotOf(context.tree, part).rotation, normalize(turn)), length(turn), {}};
  return giveDriven(context, part, motion, id, "turns it", true);
}

// An endless tween of the place to which a mover pulls.
bool fromSwing(RoleContext& context, const ConstraintSettings& settings, InstanceId id,
               InstanceId part) {
  const bool toSecond = settings.choice(id, "Mode") == kTwoAttachments &&
                        jointEnds(context.tree, id).second != kNoInstance;
  if (toSecond || !isFree(context, part)) return false;
  const Mat3 rotation = pivotOf(context.tree, part).rotation;
  for (const ScriptReading& reading : context.scripts)
    for (const Timeline& timeline : reading.timelines)
      for (const ScriptEvent& event : timeline.events) {
        const bool swings = event.target == id && event.property == "Position" &&
                            event.kind == EventKind::tween && event.tween.repeats < 0 &&
                            !std::isfinite(event.until) && timeline.byItself();
        if (!swings || event.unsure || !event.vector || !isFinite(*event.vector)) continue;
        ScriptEvent pose = event;
        pose.frame = Pose{*event.vector, rotation};
        pose.turns = false;
        const Pose start{settings.vector(id, "Position"), rotation};
        return giveDriven(context, part, endlessMotion(start, pose), id, "tweened by a script",
                          true);
      }
  return false;
}

// Where a mover pulls to in one round; where a tween leads it, a place each tenth of a second.
Goals goalsOf(const Steps& steps, const Mat3& rotation) {
  constexpr double kStep = 0.1;         // seconds
  constexpr size_t kMostGoals = 20000;  // on the ways of tweens: bounds the memory
  std::vector<const ScriptEvent*> known;
  for (const ScriptEvent* e : steps.events)
    if (e->vector) known.push_back(e);
  Goals goals;
  Vec3 last = known.empty() ? Vec3{} : *known.back()->vector;
  for (size_t i = 0; i < known.size(); ++i) {
    const ScriptEvent& e = *known[i];
    const double begin = e.time - steps.start;
    const double end = i + 1 < known.size() ? known[i + 1]->time - steps.start : steps.period;
    const double takes = e.kind == EventKind::tween ? std::min(endOf(e) - e.time, end - begin) : 0;
    const bool follows =
        takes > kStep && steps.period <= double(kLongestMotion) && goals.size() < kMostGoals;
    const int count = follows ? int(std::ceil(takes / kStep)) : 1;
    for (int k = 0; k < count; ++k) {
      const double since = (k + 1) * takes / count;
      const float share = easedShare(e.tween, shareAfter(e.tween, since));
      const Vec3 place = follows ? last + (*e.vector - last) * share : *e.vector;
      goals.emplace_back(begin + k * takes / count, Pose{place, rotation});
    }
    last = goals.back().second.position;
  }
  return goals;
}

bool fromPosition(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  const InstanceId part = movedPart(context.tree, id);
  if (part == kNoInstance) return false;
  const auto steps = stepsOf(context, id, {"Position", "position"});
  if (!steps) return fromSwing(context, settings, id, part);
  const Pose own = pivotOf(context.tree, part);
  const Goals goals = goalsOf(*steps, own.rotation);
  if (goals.empty()) return false;
  const double limit = propertyOr(context.tree.at(id), "MaxVelocity", 0.0);
  Motion motion = stepped(own, goals, *steps, std::isfinite(limit) ? limit : 0);
  return giveDriven(context, part, std::move(motion), id, "stepped by a script", true);
}

// Summed up over what is joined.
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

// What is aligned with a part that goes from place to place goes with it.
bool fromFollower(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  if (settings.choice(id, "Mode") != kTwoAttachments) return false;
  const auto drive = driveOf(context, id);
  if (!drive || !drive->reversed || !baseMoves(context, *drive)) return false;
  const Motion& way = *context.part(drive->base)->motion;
  const bool turns = std::any_of(way.keys.begin(), way.keys.end(), [&](const MotionKey& key) {
    return !samePose({{}, key.pose.rotation}, {{}, way.keys.front().pose.rotation});
  });
  const Pose own = attachmentFrame(context.tree, context.tree.at(id), "Attachment0", drive->moving);
  constexpr float kNear = 1;  // studs
  if (way.spin || turns || !(length(own.position - drive->frame.position) <= kNear)) return false;
  return giveDriven(context, *drive, Motion{}, "follows a moving part", true);
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
  if (name == "AlignPosition" && fromFollower(context, settings, id)) return true;
  return isHolder(name) && fromPosition(context, settings, id);
}

void noteTurning(RoleContext& context, const ConstraintSettings& settings, InstanceId id) {
  if (!isPusher(context.tree.at(id).className)) return;
  const InstanceId part = movedPart(context.tree, id);
  const PartDraft* draft = part == kNoInstance ? nullptr : context.part(part);
  if (!draft || !draft->motion || !draft->motion->spin || !draft->motion->carries) return;
  const auto force = forceOf(context.tree, settings, id);
  const char* const name = velocityName(context.tree, id);
  const bool moves = stepsOf(context, id, {name}) || length(settings.vector(id, name)) >= 1e-3f;
  if (moves && (!force || length(*force) > 0))
    context.level.noteUnmodelled("part that two movers move", context.tree.path(part),
                                 "it only turns in place; " + context.tree.path(id));
}

bool isPusher(const std::string& className) {
  return className == "BodyVelocity" || className == "LinearVelocity";
}

bool isHolder(const std::string& className) {
  return className == "BodyPosition" || className == "AlignPosition";
}

}  // namespace obby::importer
