// Carries everything that stands on the part at the velocity of its surface.
#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {

Status compileConveyor(PartContext& c) {
  const auto record = c.part.getConveyor();
  OBBY_ASSIGN(c.roles.conveyorVelocity, position(record.getVelocity(), "conveyor.velocity"));
  OBBY_ASSIGN(c.roles.conveyorAngular, position(record.getAngular(), "conveyor.angular"));
  c.flags |= kConveyor;
  return {};
}

}  // namespace obby::level
