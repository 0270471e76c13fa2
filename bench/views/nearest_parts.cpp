#include <algorithm>

#include "views/other_views.h"
#include "views/view_frame.h"

namespace obby::bench {

static_assert(kListedParts * kPartNumbers <= kViewInputs);

Turns nearestParts(const policy::Scene& scene, const sim::World& world,
                   const sim::RigidBody* bodies, float* inputs) {
  const Turns ahead = observeAllButMaps(scene, world, bodies, inputs);
  std::vector<PartInSight> parts = partsInSight(scene, world, bodies, ahead);
  const int listed = std::min(int(parts.size()), kListedParts);
  std::partial_sort(parts.begin(), parts.begin() + listed, parts.end());
  for (int i = 0; i < listed; ++i) {
    const PartInSight& part = parts[size_t(i)];
    std::copy(part.features.begin(), part.features.end(), inputs + partInput(i, kPartCenter));
  }
  return ahead;
}

}  // namespace obby::bench
