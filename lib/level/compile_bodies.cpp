#include "level/compile_bodies.h"

#include "level/mass.h"
#include "level/record_values.h"

namespace obby::level {

bool isDynamic(schema::Part::Reader part) {
  return !part.getAnchored() && part.getSolid() && !part.hasMotion() && !part.hasFall();
}

Result<DynamicBody> bodyFrom(schema::Part::Reader part, Vec3 at,
                             const std::vector<Collider>& colliders, size_t first) {
  if (part.hasVanish() || part.hasOneWay()) {
    return pathError(part.hasVanish() ? "vanish" : "oneWay",
                     "a dynamic part cannot vanish or be one-way",
                     "set \"anchored\":true, or remove this field");
  }
  if (!(part.getDensity() >= 1e-4f && part.getDensity() <= 100))
    return pathError("density",
                     "expected a number from 0.0001 to 100, found " + shown(part.getDensity()));
  std::vector<SolidShape> shapes;
  float radius = 0;
  for (size_t i = first; i < colliders.size(); ++i) {
    shapes.push_back({colliders[i].kind, colliders[i].shape});
    radius = maxf(radius, length(colliders[i].shape.half));
  }
  const MassProperties mass = massOf(shapes, part.getDensity());
  if (!(mass.mass > 0))
    return pathError("size", "the shape of a dynamic part must have a volume",
                     "set \"anchored\":true");
  OBBY_ASSIGN(const Quat turned, quaternion(part.getRotation(), "rotation"));
  DynamicBody bodies{at, turned, mass.center, mass.inverseInertia, 1 / mass.mass, 0, 0, 0};
  bodies.radius = radius + length(mass.center);
  bodies.firstCollider = uint32_t(first);
  bodies.colliderCount = uint32_t(shapes.size());
  return bodies;
}

}  // namespace obby::level
