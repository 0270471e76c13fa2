// Kills a player who is squeezed between parts. Depenetration must leave the body deep inside some
// part, and a crushing part must touch it, for long enough.
#pragma once

#include "sim/trip.h"

namespace obby::sim {

struct Squeeze {
  float depth = 0;                  // deepest overlap that remains
  uint32_t crusher = level::kNone;  // part that crushes and touches the body
};

OBBY_DEVICE Squeeze findSqueeze(const World& w, const level::LevelView& level,
                                const Candidates& near) {
  const Params& p = level.params;
  const Motion m{w.position, w.velocity, sinCos(w.yaw), bodyBottom(w.state, p), {}, 0, 0};
  const geom::UprightBox box = bodyBox(m, p);
  const Box bounds = box.bounds();
  Squeeze s;
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if (!(c.flags & level::kSolid) || !overlaps(bounds, c.bounds)) continue;
    const level::Collider& collider = level.colliders[c.collider];
    const float depth = contactWith(collider, c, box).depth;
    if (depth < 0) continue;
    s.depth = maxf(s.depth, depth);
    if ((c.flags & level::kCrush) && s.crusher == level::kNone) s.crusher = collider.part;
  }
  return s;
}

// Runs after the tick's motion. The level's crush clock counts the ticks.
OBBY_DEVICE void squeeze(World& w, const level::LevelView& level, const Candidates& near) {
  if (level.crushClock == level::kNone) return;
  Squeeze s;
  if (near.anyFlags & level::kCrush) s = findSqueeze(w, level, near);
  if (s.crusher == level::kNone || s.depth <= level.params.squeezeDepth) {
    stopClock(w, level.crushClock);
    return;
  }
  startClock(w, level, level.crushClock);
  const int i = findClock(w, level.crushClock);
  if (i < 0 || w.clocks[i].ticks + 1 < level.params.squeezeTicks) return;
  w.state = State::dead;
  w.outcome = Outcome::killed;
  w.health = 0;
  w.part = s.crusher;
}

}  // namespace obby::sim
