// What a touch or use does to parts: they come, go and move.
#include <algorithm>
#include <set>

#include "import/classes.h"
#include "import/motion.h"
#include "import/observed/effect_roles.h"
#include "import/observed/roles.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr float kForever = 3600;  // seconds
constexpr const char* kStarted = "motion that a touch or click starts";

}  // namespace

void EffectRoles::takeParts(PartDraft& part, bool used, const ProbeEffects& effects) {
  Press press;
  press.signal = "touch " + path(part.id);
  for (const Away& away : effects.aways) takeAway(part, used, away, false, press);
  for (const Away& back : effects.backs) takeAway(part, used, back, true, press);
  for (const Moved& moved : effects.moved)
    if (moved.driver == kNoInstance) takeMoved(part, used, moved, press);
  givePress(part, press);
  for (const auto& [id, line] : effects.sizes)
    note("size that scripts change", id, "stays as it is at the start; ", line);
  for (const auto& [id, line] : effects.belts)
    if (context_.part(id)) note("conveyor that a touch changes", id, "", line);
}

void EffectRoles::givePress(PartDraft& part, const Press& press) {
  if (!press.presses) return;
  if (!part.button) prove(part, "button", "a touch changes other parts");
  Button button = part.button.value_or(Button{press.signal, 0, false});
  button.forever = button.forever || press.forever;
  button.seconds = std::max(button.seconds, press.forever ? kForever : float(press.longest));
  part.button = button;
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

void EffectRoles::takeDrives(PartDraft& part, bool used, const ProbeEffects& effects) {
  Press press;
  press.signal = "touch " + path(part.id);
  std::set<InstanceId> done;
  for (const Moved& moved : effects.moved) {
    const PartDraft* const other = context_.part(moved.part);
    if (moved.driver == kNoInstance || !other || other->motion) continue;
    takeMoved(part, used, moved, press);
    done.insert(moved.driver);
  }
  givePress(part, press);
  for (const auto& [id, line] : effects.others)
    if (isJoint(id) && !done.contains(id)) note(kStarted, id, "moves or rests as before; ", line);
}

void EffectRoles::takeAway(PartDraft& part, bool used, const Away& away, bool inverted,
                           Press& press) {
  PartDraft* const other = context_.part(away.part);
  if (!other || other->vanish) return;
  Vanish vanish;
  vanish.delay = float(away.delay);
  vanish.inverted = inverted;
  if (!inverted) vanish.away = away.seconds ? float(*away.seconds) : kGone;
  if (inverted || other != &part || used) {
    vanish.signal = press.signal;
    press.presses = true;
    press.forever = press.forever || !away.seconds;
    press.longest = std::max(press.longest, away.delay + away.seconds.value_or(0));
  }
  other->vanish = vanish;
  other->solid = true;
  prove(*other, "vanish", reason(away.line));
}

void EffectRoles::takeMoved(PartDraft& part, bool used, const Moved& moved, Press& press) {
  constexpr size_t kRest = 30;  // frames
  PartDraft* const other = context_.part(moved.part);
  if (!other || other->motion) return;
  auto motion = motionOf(moved.poses, kRest);
  if (!motion) return note(kStarted, moved.part, "stays where it is; ", moved.line);
  const bool own = other == &part && !used;
  motion->trigger = own ? MotionTrigger::touch : MotionTrigger::signal;
  motion->offset = 0;
  motion->carries = moved.driver != kNoInstance;
  if (!own) {
    motion->signal = press.signal;
    press.presses = true;
    press.forever = press.forever || !samePose(moved.poses.front(), moved.poses.back());
    press.longest = std::max(press.longest, double(moved.poses.size()) / 60);
  }
  other->motion = motion;
  other->anchored = true;
  prove(*other, "motion", reason(moved.line));
}

}  // namespace obby::importer
