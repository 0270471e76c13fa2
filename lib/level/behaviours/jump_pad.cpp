// Throws a player who touches the part.
#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {

Status compileJumpPad(PartContext& c) {
  const auto record = c.part.getJumpPad();
  OBBY_ASSIGN(c.roles.padVelocity, position(record.getVelocity(), "jumpPad.velocity"));
  c.roles.padKeepsSideways = record.getKeepSideways();
  c.flags |= kPad;
  return {};
}

}  // namespace obby::level
