// Mass, centre and inertia of a dynamic part, from its shapes and its density.
#pragma once

#include <span>

#include "geom/shape.h"

namespace obby::level {

// One convex shape of the part, in the part's frame.
struct SolidShape {
  geom::ShapeKind kind;
  geom::ShapeData data;
};

struct MassProperties {
  float mass = 0;       // density x cubic studs
  Vec3 center;          // centre of mass, studs, in the part's frame
  Mat3 inverseInertia;  // about the centre, in the part's frame
};

// The shapes of one part must not overlap. The mass is 0 if they have no volume.
MassProperties massOf(std::span<const SolidShape> shapes, float density);

}  // namespace obby::level
