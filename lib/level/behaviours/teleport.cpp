// Teleports a player who touches the part.
#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {

Status compileTeleport(PartContext& c) {
  const auto record = c.part.getTeleport();
  OBBY_ASSIGN(c.roles.teleportTo, position(record.getPosition(), "teleport.position"));
  OBBY_ASSIGN(const float yaw, angle(record.getYaw(), "teleport.yaw"));
  c.roles.teleportYaw = turnsFromRadians(yaw);
  c.roles.teleportTurns = record.getTurns();
  c.roles.teleportKeepsVelocity = record.getKeepVelocity();
  c.flags |= kTeleport;
  return {};
}

}  // namespace obby::level
