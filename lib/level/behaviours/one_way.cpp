// Solid for a player on one side of it only.
#include "level/behaviours/behaviour.h"
#include "level/record_values.h"

namespace obby::level {

Status compileOneWay(PartContext& c) {
  const Vec3 direction = vec(c.part.getOneWay().getDirection());
  if (!isFinite(direction) || length(direction) < 1e-6f) {
    return pathError("oneWay.direction", "expected a direction in the part's frame",
                     "[0,1,0] makes the top solid");
  }
  c.roles.oneWay = normalize(direction);
  c.flags |= kOneWay;
  return {};
}

}  // namespace obby::level
