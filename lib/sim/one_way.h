// Parts that are solid from one side only. The test is stateless: it uses the player's position at
// the start of a tick. A body that was outside is pushed out in every substep, so that it is
// outside at the next tick's start as well. A body from the other side passes.
#pragma once

#include "geom/contact.h"
#include "geom/shapes/table.h"
#include "sim/clocks.h"

namespace obby::sim {

// Returns torso and head as a box; the legs never collide.
OBBY_DEVICE geom::UprightBox torsoOf(const World& w, const Params& p) {
  const float half = (p.bodyTop - p.hipHeight) * 0.5f;
  return {w.position + Vec3{0, p.hipHeight + half, 0},
          {p.bodyWidth * 0.5f, half, p.bodyDepth * 0.5f},
          sinCos(w.yaw)};
}

// Returns true if the whole torso is beyond the part's surface, on the side that is solid.
OBBY_DEVICE bool isOutside(const World& w, const level::LevelView& level, const level::Collider& c,
                           const Pose& pose) {
  const Vec3 local = level.roles[c.role].oneWay, out = pose.rotation * local;
  const float surface = dot(out, pose.position) + geom::visitShape(c.kind, [&](auto shape) {
                          return decltype(shape)::support(c.shape, local);
                        });
  const geom::UprightBox body = torsoOf(w, level.params);
  const float nearest = dot(out, body.center) - dot(abs(toLocal(body.axes(), out)), body.half);
  return nearest >= surface - level.params.oneWaySlack;
}

}  // namespace obby::sim
