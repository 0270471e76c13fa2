#include "solve/report/difficulty/clearance.h"

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
  const Vec3 clearance = half - abs(toLocal(pose, feet));
  if (up.y >= up.x && up.y >= up.z) return minf(clearance.x, clearance.z);
  return up.x >= up.z ? minf(clearance.y, clearance.z) : minf(clearance.x, clearance.y);
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
                  std::span<const sim::RigidBody> bodies, uint32_t id) {
  const level::Collider& c = level.colliders[id];
  if (sim::isGone(c, bodies.data())) return kLookForKills;
  const Convex kill{c.kind, c.shape, sim::poseAfter(level, w, bodies.data(), c)};
  const sim::Limbs limbs = sim::limbsOf(w, level.params);
  const Box near = grow(join(limbs.arms.bounds(), limbs.column.bounds()),
                        {kLookForKills, kLookForKills, kLookForKills});
  if (!overlaps(near, boundsOf(kill.pose, c.shape.half))) return kLookForKills;
  const float min =
      level.bounds[id].flags & level::kByRoot
          ? apart(convexOf(limbs.root), kill)
          : minf(apart(convexOf(limbs.arms), kill), apart(convexOf(limbs.column), kill));
  return clampf(min, 0.0f, kLookForKills);
}

}  // namespace

float landingMargin(const level::LevelView& level, const Course& course, uint32_t tick,
                    int32_t part) {
  const sim::World& w = course.at(tick);
  const auto bodies = course.replay.bodiesAtTick(tick);
  float best = -1e30f;
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    const level::Collider& c = level.colliders[id];
    if (int32_t(c.part) != part) continue;
    const Pose pose = sim::poseAfter(level, w, bodies.data(), c);
    best = std::max(best, marginOn(pose, c.shape.half, w.position));
  }
  return best;
}

float killClearance(const level::LevelView& level, const Course& course, const Segment& segment) {
  float min = kLookForKills;
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    if (!(level.bounds[id].flags & level::kKill)) continue;
    for (uint32_t t = segment.start; t <= segment.end(); ++t) {
      min = std::min(min, clearanceTo(level, course.at(t), course.replay.bodiesAtTick(t), id));
    }
  }
  return min < kLookForKills ? min : -1;
}

}  // namespace obby::solve
