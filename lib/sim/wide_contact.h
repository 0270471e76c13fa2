// Does collide() of body.h for lanes of worlds, each among up to kLaneSolids parts of its own. Part
// of the wide tick (wide_tick.h); host only.
#pragma once

#include "sim/wide_state.h"

namespace obby::sim {

constexpr int kLaneSolids = 4;

using WideBlock = geom::BlockT<WideFloat>;

// The parts that the bodies of kLanes worlds can meet.
struct Obstacles {
  WideBlock block[kLaneSolids];
  BoxT<WideFloat> bounds[kLaneSolids];
  WideMask upright[kLaneSolids];
  WideInt count;  // parts of each lane
  int max = 0;    // max of all lanes
};

namespace internal {

OBBY_LANES geom::ContactT<WideFloat> contactOf(const WideBlock& block, WideMask upright,
                                               WideMask asked,
                                               const geom::UprightBoxT<WideFloat>& box) {
  if (!any(asked & upright)) return geom::boxTiltedBlock<WideFloat>(block, box);
  geom::ContactT<WideFloat> contact = geom::boxUprightBlock<WideFloat>(block, box);
  if (any(asked & !upright)) {
    const geom::ContactT<WideFloat> tilted = geom::boxTiltedBlock<WideFloat>(block, box);
    contact.depth = select(upright, contact.depth, tilted.depth);
    contact.normal = select(upright, contact.normal, tilted.normal);
  }
  return contact;
}

}  // namespace internal

OBBY_LANES WideMask isInside(const WideMotion& m, const Params& p, const Obstacles& o,
                             WideMask asked) {
  const geom::UprightBoxT<WideFloat> box = bodyBox(m, p);
  const BoxT<WideFloat> bounds = box.bounds();
  WideMask inside;
  for (int k = 0; k < o.max; ++k) {
    const WideMask near = asked & (o.count > k) & overlaps(bounds, o.bounds[k]);
    if (!any(near)) continue;
    const auto contact = internal::contactOf(o.block[k], o.upright[k], near, box);
    inside |= near & (contact.depth > WideFloat(p.contactSkin + kTight));
  }
  return inside;
}

// Returns the lanes whose body does not fit between its parts.
OBBY_LANES WideMask collide(WideMotion& m, const Params& p, const Obstacles& o) {
  WideMask busy(true);
  for (int round = 0; round < contactRounds(o.max); ++round) {
    WideMask pushed;
    geom::UprightBoxT<WideFloat> box = bodyBox(m, p);
    BoxT<WideFloat> bounds = box.bounds();
    for (int k = 0; k < o.max; ++k) {
      const WideMask asked = busy & (o.count > k) & overlaps(bounds, o.bounds[k]);
      if (!any(asked)) continue;
      const auto contact = internal::contactOf(o.block[k], o.upright[k], asked, box);
      const WideMask moved = pushOut(m, p, contact, asked);
      if (!any(moved)) continue;
      pushed |= moved;
      box = bodyBox(m, p);
      bounds = box.bounds();
    }
    busy = pushed & (o.count > 1);
    if (!any(busy)) return WideMask();
  }
  return isInside(m, p, o, busy);
}

// Does moveAmong() of body.h for lanes.
OBBY_LANES void moveAmong(WideMotion& m, const Params& p, const Obstacles& o, float dt) {
  const Vec3T<WideFloat> from = m.position;
  m.position += m.velocity * WideFloat(dt);
  const WideMask stuck = collide(m, p, o);
  if (!any(stuck)) return;
  m.position.x = select(stuck, from.x, m.position.x);
  m.position.z = select(stuck, from.z, m.position.z);
}

}  // namespace obby::sim
