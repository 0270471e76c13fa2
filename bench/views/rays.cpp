#include <algorithm>
#include <iterator>

#include "views/other_views.h"
#include "views/view_frame.h"

namespace obby::bench {

namespace {

static_assert(policy::kMoments * policy::kKinds * kRays == kViewInputs);

constexpr Vec3 kEye{0, kEyeHeight, 0};  // relative to the feet
// Studs by which a visible danger may lie behind a floor, since flush surfaces differ by rounding.
constexpr float kFlush = 0.01f;

// Returns axes whose y is a ray `degrees` above the horizontal direction `flat`.
Mat3 axesOfRay(Vec3 flat, float degrees) {
  const SinCos up = sinCos(turnsFromRadians(degrees * (kPi / 180)));
  const Vec3 side{-flat.z, 0, flat.x}, ray = flat * up.cos + Vec3{0, up.sin, 0};
  return {side, ray, cross(side, ray)};
}

// Returns the distance to the solid along the y axis of `axes`, at most kRayReach. `radius`: the
// solid's bounding radius.
float distanceAlong(const Mat3& axes, const policy::Solid& solid, float radius) {
  const Vec3 c = toLocal(axes, solid.center - kEye);
  if (c.x * c.x + c.z * c.z > radius * radius || c.y < -radius || c.y > kRayReach + radius)
    return kRayReach;
  const policy::Stretch<float> in = policy::cut<float>(along(axes, kEye, solid), 0.0f, 0.0f);
  if (in.bottom > in.top || in.top < 0) return kRayReach;
  return clampf(in.bottom, 0.0f, kRayReach);
}

// Returns 0 at the end of a ray.
float closeness(float distance) { return 1 - distance / kRayReach; }

// The distance along each ray to the nearest solid of each kind.
class Bundle {
 public:
  explicit Bundle(Turns ahead) {
    axes_[0] = axesOfRay(policy::rosetteDirection(ahead, 0), -90);
    for (int d = 0; d < policy::kDirections; ++d) {
      const Vec3 flat = policy::rosetteDirection(ahead, d);
      for (int e = 0; e < kElevations; ++e) axes_[rayAt(e, d)] = axesOfRay(flat, kRayDegrees[e]);
    }
    for (auto& moment : nearest_) {
      for (auto& kind : moment) std::fill(std::begin(kind), std::end(kind), kRayReach);
    }
  }

  void see(const policy::Sight& sight) {
    const policy::Solid solid =
        sight.kind == policy::kDanger ? policy::widened(sight.solid) : sight.solid;
    const float radius = length(solid.shape.half);
    for (int r = 0; r < kRays; ++r) {
      const float distance = distanceAlong(axes_[r], solid, radius);
      for (int m = 0; m < policy::kMoments; ++m) {
        float& nearest = nearest_[m][sight.kind][r];
        if (sight.moments >> m & 1) nearest = minf(nearest, distance);
      }
    }
  }

  // Writes the inputs. As in the maps, each moment after the first is a difference from the moment
  // before.
  void tell(float* inputs) const {
    for (int r = 0; r < kRays; ++r) {
      float floorBefore = 0, dangerBefore = 0;
      for (int m = 0; m < policy::kMoments; ++m) {
        const float toFloor = nearest_[m][policy::kFloor][r];
        const float toDanger = nearest_[m][policy::kDanger][r];
        const float floor = closeness(toFloor);
        const float danger = toDanger > toFloor + kFlush ? 0 : closeness(toDanger);
        inputs[rayInput(m, policy::kFloor, r)] = floor - floorBefore;
        inputs[rayInput(m, policy::kDanger, r)] = danger - dangerBefore;
        floorBefore = floor;
        dangerBefore = danger;
      }
    }
  }

 private:
  Mat3 axes_[kRays];
  float nearest_[policy::kMoments][policy::kKinds][kRays];
};

}  // namespace

Turns rays(const policy::Scene& scene, const sim::World& world, const sim::RigidBody* bodies,
           float* inputs) {
  const Turns ahead = observeAllButMaps(scene, world, bodies, inputs);
  Bundle bundle(ahead);
  policy::lookAround(scene, world, bodies, [&](const policy::Sight& sight) { bundle.see(sight); });
  bundle.tell(inputs);
  return ahead;
}

}  // namespace obby::bench
