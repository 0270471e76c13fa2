// What a touch or use does to parts: they come, go and move.
#include <algorithm>

#include "import/motion.h"
#include "import/observed/effect_roles.h"
#include "import/observed/roles.h"
#include "import/pose_math.h"

namespace obby::importer {
namespace {

constexpr float kForever = 3600;  // seconds

}  // namespace

void EffectRoles::takeParts(PartDraft& part, bool used, const ProbeEffects& effects) {
  Press press;
  press.signal = "touch " + path(part.id);
  for (const Away& away : effects.aways) takeAway(part, used, away, false, press);
  for (const Away& back : effects.backs) takeAway(part, used, back, true, press);
  for (const Moved& moved : effects.moved) takeMoved(part, used, moved, press);
  if (press.presses) {
    part.button =
        Button{press.signal, press.forever ? kForever : float(press.longest), press.forever};
    prove(part, "button", "a touch changes other parts");
  }
  for (const auto& [id, line] : effects.sizes)
    note("size that scripts change", id, "stays as it is at the start; ", line);
  for (const auto& [id, line] : effects.belts) note("conveyor that a touch changes", id, "", line);
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
  if (!motion)
    return note("motion that a touch or click starts", moved.part, "stays where it is; ",
                moved.line);
  const bool own = other == &part && !used;
  motion->trigger = own ? MotionTrigger::touch : MotionTrigger::signal;
  motion->offset = 0;
  if (!own) {
    motion->signal = press.signal;
    press.presses = true;
    press.forever = press.forever || !samePose(moved.poses.front(), moved.poses.back());
    press.longest = std::max(press.longest, double(moved.poses.size()) / 60);
  }
  other->motion = motion;
  prove(*other, "motion", reason(moved.line));
}

}  // namespace obby::importer
