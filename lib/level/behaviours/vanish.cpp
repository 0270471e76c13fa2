// Loses its collision for a time: by the level's clock, after a touch, or while a signal lasts.
#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

Status byTimer(PartContext& c) {
  if (c.roles.vanishDelay + c.roles.vanishAway == 0) {
    return pathError("vanish", "a period of 0 ticks", "give delay or away");
  }
  c.flags |= kVanishTimer;
  return {};
}

Status bySignal(PartContext& c) {
  OBBY_ASSIGN(c.roles.awayClock, c.clocks.signal(c.part.getVanish().getSignal(), "vanish.signal"));
  c.flags |= kClocked;
  return {};
}

Status byTouch(PartContext& c) {
  if (!c.part.getTouch()) return {};
  OBBY_RETURN_IF_ERROR(startOwn(c, c.roles.vanishDelay + c.roles.vanishAway, "vanish"));
  c.roles.awayClock = kOwnClock;
  c.flags |= kClocked;
  return {};
}

}  // namespace

Status compileVanish(PartContext& c) {
  const auto record = c.part.getVanish();
  c.roles.vanishDelay = ticksFromSeconds(c.params, record.getDelay());
  c.roles.vanishAway = ticksFromSeconds(c.params, record.getAway());
  c.roles.vanishPhase = ticksFromSeconds(c.params, record.getPhase());
  c.roles.vanishInverted = record.getInverted();
  c.roles.awayFrom = c.roles.vanishDelay;
  const bool signal = record.getTrigger() == schema::VanishTrigger::SIGNAL;
  if (record.getSignal().size() != 0 && !signal) {
    return pathError("vanish.signal", "does nothing with this trigger",
                     "set \"trigger\":\"signal\"");
  }
  if (signal) return bySignal(c);
  return record.getTrigger() == schema::VanishTrigger::TIMER ? byTimer(c) : byTouch(c);
}

}  // namespace obby::level
