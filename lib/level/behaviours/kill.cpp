// Takes health from a player who touches the part, or gives it back.
#include <algorithm>
#include <cmath>

#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {

Status compileKill(PartContext& c) {
  const auto record = c.part.getKill();
  OBBY_ASSIGN(const uint32_t cooldown, ticksOf(c.params, record.getCooldown(), "kill.cooldown"));
  if (!std::isfinite(record.getDamage())) {
    return pathError("kill.damage", "expected a finite number, found " + shown(record.getDamage()));
  }
  c.roles.damage = record.getDamage();
  if (c.roles.damage < 0) {
    c.flags |= kHeal;
    if (cooldown != 0) c.roles.healClock = c.clocks.add({cooldown});
    return {};
  }
  c.roles.cooldownTicks = uint16_t(std::min(cooldown, 65535u));
  c.flags |= kKill;
  return {};
}

}  // namespace obby::level
