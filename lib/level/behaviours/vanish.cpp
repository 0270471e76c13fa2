// Removes the part's collision for a time: by the level's clock, after a touch, or during a signal.
#include <cmath>

#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {
namespace {

// Returns the ticks into the period at tick 0. A negative phase counts back from the period's end.
Result<uint32_t> phaseOf(const Params& params, float phase, uint32_t period) {
  if (!std::isfinite(phase)) {
    return pathError("vanish.phase", "expected a finite number of seconds, found " + shown(phase));
  }
  const uint32_t ticks = ticksFromSeconds(params, std::fabs(phase));
  return phase < 0 ? (period - ticks % period) % period : ticks;
}

Status byTimer(PartContext& c) {
  const uint32_t period = c.roles.vanishDelay + c.roles.vanishAway;
  if (period == 0)
    return pathError("vanish", "the timer's period lasts less than one tick",
                     "raise 'delay' or 'away'");
  OBBY_ASSIGN(c.roles.vanishPhase, phaseOf(c.params, c.part.getVanish().getPhase(), period));
  c.flags |= kVanishTimer;
  return {};
}

Status bySignal(PartContext& c) {
  OBBY_ASSIGN(c.roles.awayClock, c.clocks.signal(c.part.getVanish().getSignal(), "vanish.signal"));
  c.flags |= kClocked;
  return {};
}

Status byTouch(PartContext& c) {
  if (c.part.getTouch()) {
    OBBY_RETURN_IF_ERROR(startOwn(c, c.roles.vanishDelay + c.roles.vanishAway, "vanish"));
    c.roles.awayClock = kOwnClock;
  } else if (!c.roles.vanishInverted) {
    return {};  // the part never vanishes
  }
  c.flags |= kClocked;
  return {};
}

}  // namespace

Status compileVanish(PartContext& c) {
  const auto record = c.part.getVanish();
  OBBY_ASSIGN(c.roles.vanishDelay, ticksOf(c.params, record.getDelay(), "vanish.delay"));
  OBBY_ASSIGN(c.roles.vanishAway, ticksOf(c.params, record.getAway(), "vanish.away"));
  c.roles.vanishInverted = record.getInverted();
  c.roles.awayFrom = c.roles.vanishDelay;
  const bool signal = record.getTrigger() == schema::VanishTrigger::SIGNAL;
  if (record.getSignal().size() != 0 && !signal) {
    return pathError("vanish.signal", "a signal has no effect with this trigger",
                     "set \"trigger\":\"signal\", or remove the signal");
  }
  if (signal) return bySignal(c);
  return record.getTrigger() == schema::VanishTrigger::TIMER ? byTimer(c) : byTouch(c);
}

}  // namespace obby::level
