#include "solve/report/difficulty/room.h"

#include <algorithm>

#include "geom/separation.h"
#include "sim/targets.h"

namespace obby::solve {

namespace {

using geom::Convex;
using geom::ShapeKind;

// Returns the distance from the feet to the nearest side of the box's most upward face; negative
// outside.
float marginOn(const Pose& pose, Vec3 half, Vec3 feet) {
  const Vec3 up = abs(Vec3{pose.rotation.x.y, pose.rotation.y.y, pose.rotation.z.y});
  const Vec3 room = half - abs(toLocal(pose, feet));
  if (up.y >= up.x && up.y >= up.z) return minf(room.x, room.z);
  return up.x >= up.z ? minf(room.y, room.z) : minf(room.x, room.y);
}

Convex convexOf(const geom::UprightBox& box) {
  return {ShapeKind::block, {box.half}, {box.center, box.axes()}};
}

float apart(Convex body, Convex kill) {
  if (kill.kind == ShapeKind::cylinder) return geom::separation(body, kill, kLookForKills).distance;
  // Positions are relative to the body: far from the world's origin floats are too coarse.
  kill.pose.position -= body.pose.position;
  body.pose.position = {};
  const float core = length(geom::closestApproach(body, kill, 0));
  return kill.kind == ShapeKind::ball ? core - geom::Ball::radius(kill.shape) : core;
}

// Returns the distance to one kill part, at most kLookForKills.
float clearanceTo(const level::LevelView& level, const sim::World& w,
                  std::span<const sim::LooseBody> loose, uint32_t id) {
  const level::Collider& c = level.colliders[id];
  if (sim::isGone(c, loose.data())) return kLookForKills;
  const Convex kill{c.kind, c.shape, sim::poseAfter(level, w, loose.data(), c)};
  const sim::Limbs limbs = sim::limbsOf(w, level.params);
  const Box near = grow(join(limbs.arms.bounds(), limbs.column.bounds()),
                        {kLookForKills, kLookForKills, kLookForKills});
  if (!overlaps(near, boundsOf(kill.pose, c.shape.half))) return kLookForKills;
  const float least =
      level.bounds[id].flags & level::kByRoot
          ? apart(convexOf(limbs.root), kill)
          : minf(apart(convexOf(limbs.arms), kill), apart(convexOf(limbs.column), kill));
  return clampf(least, 0.0f, kLookForKills);
}

}  // namespace

float landingMargin(const level::LevelView& level, const Course& course, uint32_t tick,
                    int32_t part) {
  const sim::World& w = course.at(tick);
  const auto loose = course.replay.looseAt(tick);
  float best = -1e30f;
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    const level::Collider& c = level.colliders[id];
    if (int32_t(c.part) != part) continue;
    const Pose pose = sim::poseAfter(level, w, loose.data(), c);
    best = std::max(best, marginOn(pose, c.shape.half, w.position));
  }
  return best;
}

float killClearance(const level::LevelView& level, const Course& course, const Segment& segment) {
  float least = kLookForKills;
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    if (!(level.bounds[id].flags & level::kKill)) continue;
    for (uint32_t t = segment.start; t <= segment.end(); ++t) {
      least = std::min(least, clearanceTo(level, course.at(t), course.replay.looseAt(t), id));
    }
  }
  return least < kLookForKills ? least : -1;
}

}  // namespace obby::solve
