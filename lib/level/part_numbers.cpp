#include "level/part_numbers.h"

#include <fmt/format.h>

#include "level/record_values.h"

namespace obby::level {

Result<Vec3> halfExtents(schema::Part::Reader part) {
  const Vec3 size = vec(part.getSize());
  if (!isFinite(size) || !(size.x > 0 && size.y > 0 && size.z > 0) ||
      maxf(size.x, maxf(size.y, size.z)) > kMaxSize) {
    return pathError("size",
                     "expected three numbers above 0 and at most 2048, found " + shown(size));
  }
  return max(size, Vec3{kMinSize, kMinSize, kMinSize}) * 0.5f;
}

Status checkSurface(schema::Part::Reader part) {
  if (!(part.getFriction() >= 0 && part.getFriction() <= kMaxFriction))
    return pathError("friction", fmt::format("expected a number from 0 to {}, found {}",
                                             kMaxFriction, part.getFriction()));
  if (!(part.getFrictionWeight() >= 0 && part.getFrictionWeight() <= kMaxFrictionWeight))
    return pathError("frictionWeight", fmt::format("expected a number from 0 to {}, found {}",
                                                   kMaxFrictionWeight, part.getFrictionWeight()));
  if (!(part.getElasticity() >= 0 && part.getElasticity() <= 1))
    return pathError("elasticity",
                     "expected a number from 0 to 1, found " + shown(part.getElasticity()));
  return {};
}

}  // namespace obby::level
