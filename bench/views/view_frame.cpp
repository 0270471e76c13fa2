#include "views/view_frame.h"

#include <algorithm>

#include "views/other_views.h"

namespace obby::bench {

Turns observeAllButMaps(const policy::Scene& scene, const sim::World& world,
                        const sim::RigidBody* bodies, float* inputs) {
  const sim::NextRegion next = sim::nextRegion(scene.query, world);
  const Turns ahead = policy::aheadOf(*next.region, world);
  policy::observeOthers(scene, world, bodies, next, ahead, inputs);
  std::fill_n(inputs + policy::kMapsAt, kViewInputs, policy::kEmptyInput);
  return ahead;
}

policy::Solid along(const Mat3& axes, Vec3 origin, policy::Solid solid) {
  solid.center = toLocal(axes, solid.center - origin);
  solid.axes = {toLocal(axes, solid.axes.x), toLocal(axes, solid.axes.y),
                toLocal(axes, solid.axes.z)};
  return solid;
}

}  // namespace obby::bench
