// Gives parts the effects of a touch or use: they appear, vanish and move.
#include <algorithm>
#include <set>

#include "import/document/classes.h"
#include "import/draft/motion.h"
#include "import/observed/effect_roles.h"
#include "import/observed/roles.h"

namespace obby::importer {
namespace {

constexpr double kForever = 3600;  // seconds
// Returns true for the state that broughtFromObservation() has set.
bool isNeverThere(const Vanish& vanish) {
  return vanish.inverted && !vanish.timer && vanish.signal.empty();
}

constexpr const char* kStarted = "motion that a touch or click starts";

}  // namespace

void EffectRoles::takeParts(PartDraft& part, bool used, const ProbeEffects& effects) {
  for (const Away& away : effects.aways) takeAway(part, used, away, false);
  for (const Away& back : effects.backs) takeAway(part, used, back, true);
  for (const Moved& moved : effects.moved) {
    PartDraft* const other = context_.part(moved.part);
    if (!other || moved.driver != kNoInstance) continue;
    if (!other->motion)
      takeMotion(part, *other, moved, used);
    else if (other->motion->trigger == MotionTrigger::always)
      note(kStarted, moved.part, "simulated with only the motion that it has without the touch; ",
           moved.line);
  }
  for (const Changed& size : effects.sizes)
    note("size that scripts change", size.part, "simulated with its size at the start; ",
         size.line);
  for (const Changed& belt : effects.belts)
    if (context_.part(belt.part))
      note("conveyor that a touch changes", belt.part, "not simulated; ", belt.line);
}

void EffectRoles::takeDrives(PartDraft& part, const engine::Probe& probe,
                             const ProbeEffects& effects) {
  std::set<InstanceId> done;
  for (const Moved& moved : effects.moved) {
    PartDraft* const other = context_.part(moved.part);
    if (moved.driver == kNoInstance || !other || other->motion) continue;
    takeMotion(part, *other, moved, probe.approach == engine::Approach::use);
    done.insert(moved.driver);
  }
  for (const auto& [id, line] : effects.others)
    if (isJoint(id) && !done.contains(id)) note(kStarted, id, "not simulated; ", line);
}

bool EffectRoles::isJoint(InstanceId id) const {
  if (id >= context_.tree.size()) return false;
  const std::string& name = context_.tree.at(id).className;
  return isFreeConstraintClass(name) || isRigidJointClass(name);
}

bool EffectRoles::setsJoints(const engine::Probe& probe) const {
  const auto& changes = probe.seen.changes;
  const auto& tracks = probe.seen.tracks;
  return std::any_of(changes.begin(), changes.end(),
                     [&](const auto& change) { return isJoint(change.target); }) ||
         std::any_of(tracks.begin(), tracks.end(),
                     [](const auto& track) { return track.second.driver != kNoInstance; });
}

void EffectRoles::press(PartDraft& part, double seconds, bool held) {
  if (!part.button) prove(part, "button", "a touch changes other parts");
  Button button = part.button.value_or(Button{signalOf(part), 0, false, held});
  button.restarts = button.restarts && held;
  button.forever = button.forever || seconds >= kForever;
  button.seconds = std::max(button.seconds, float(seconds));
  part.button = button;
}

void EffectRoles::takeAway(PartDraft& part, bool used, const Away& away, bool inverted) {
  PartDraft* const other = context_.part(away.part);
  if (!other || (other->vanish && !isNeverThere(*other->vanish))) return;
  Vanish vanish;
  vanish.delay = float(away.delay);
  vanish.inverted = inverted;
  if (!inverted) vanish.away = away.seconds ? float(*away.seconds) : kGone;
  if (inverted || other != &part || used) {
    vanish.signal = signalOf(part);
    press(part, away.seconds ? away.delay + *away.seconds : kForever, away.held);
  }
  other->vanish = vanish;
  other->solid = true;
  prove(*other, "vanish", reason(away.line));
}

void EffectRoles::takeMotion(PartDraft& part, PartDraft& other, const Moved& moved, bool used) {
  constexpr size_t kRest = 30;  // frames of rest
  auto motion = motionOf(moved.poses, kRest);
  bool returns = samePose(moved.poses.front(), moved.poses.back());
  double seconds = double(moved.poses.size()) / 60;
  if (!motion && moved.outlasting) {
    motion = moved.outlasting;
    returns = motion->repeat == Repeat::once &&
              samePose(motion->keys.front().pose, motion->keys.back().pose);
    seconds = double(motion->keys.back().time);
  }
  if (!motion)
    return note(kStarted, moved.part, "not simulated; the part stays where it is; ", moved.line);
  const bool own = &other == &part && !used;
  motion->trigger = own ? MotionTrigger::touch : MotionTrigger::signal;
  if (motion->repeat != Repeat::once) motion->offset = 0;  // it rests where its keys begin
  motion->carries = moved.driver != kNoInstance;
  if (!own) {
    motion->signal = signalOf(part);
    press(part, returns ? seconds : kForever);
  }
  other.motion = motion;
  other.anchored = true;
  prove(other, "motion", reason(moved.line));
}

}  // namespace obby::importer
