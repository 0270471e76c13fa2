// Senses the floor under the player with seven rays straight down around the root, three on the
// centre line and four at the corners. Averages those that hit (docs/physics.md, floor).
#pragma once

#include "geom/box_box.h"
#include "geom/shapes/table.h"
#include "sim/candidates.h"
#include "sim/player.h"

namespace obby::sim {

constexpr int kFloorRays = 7;

template <class F>
struct FloorT {
  MaskOf<F> sensed = false;
  F gap = 0;  // studs from the feet down to the floor; negative if the floor is higher
  Vec3T<F> normal{0, 1, 0};       // average, not normalised
  Vec3T<F> velocity;              // velocity of the surface under the player, studs/s
  F turning = 0;                  // rad/s of a carrying floor about Y
  F grip = 0;                     // friction with the nearest floor
  IntOf<F> nearest = -1;          // candidate of the shortest ray; -1 for none
  uint8_t body = level::kNoBody;  // body that the player stands on; one world only
};

using Floor = FloorT<float>;

template <class F>
struct FloorRaysT {
  Vec3T<F> origin;       // centre ray, world
  Vec3T<F> right, back;  // corner offsets, world
  F reach;               // length of the rays below their origins, studs
  F distance[kFloorRays];
  Vec3T<F> normal[kFloorRays];
  bool tilted = false;  // true if a normal may differ from up
  IntOf<F> nearest;     // candidate of the shortest ray; -1 for none
  F nearestDistance;
};

// Offsets of the rays in units of (right, back).
OBBY_DEVICE float rayRight(int i) { return i < 3 ? float(i - 1) : (i & 1) ? -1.0f : 1.0f; }
OBBY_DEVICE float rayBack(int i) { return i < 3 ? 0.0f : i < 5 ? -1.0f : 1.0f; }

// Returns the height of the rays' origins above the feet.
OBBY_DEVICE float rayHeight(const Params& p) {
  return p.hipHeight + p.rootHeight * 0.5f - p.floorRayStart * p.rootHeight;
}

template <class F>
OBBY_DEVICE FloorRaysT<F> makeRays(const PlayerT<F>& w, const Params& p) {
  const SinCosT<F> yaw = sinCosOf<F>(w.yaw);
  FloorRaysT<F> rays;
  rays.origin = w.position + Vec3T<F>{0, rayHeight(p), 0};
  const F x = p.bodyWidth * p.floorRaySpread, z = p.bodyDepth * p.floorRaySpread;
  rays.right = {yaw.cos * x, 0, -yaw.sin * x};
  rays.back = {yaw.sin * z, 0, yaw.cos * z};
  const F hysteresis = select(w.sensed, F(p.floorKeep), F(p.floorAcquire));
  rays.reach = p.floorReachBase * p.rootHeight + hysteresis * p.hipHeight;
  // A fast fall extends the rays to the distance of one tick, so that it does not miss a thin
  // floor.
  const F fall = -w.velocity.y * p.tickSeconds;
  rays.reach = select(fall > rays.reach, fall, rays.reach);
  rays.reach = select(w.velocity.y < -p.fastFall, rays.reach + (-w.velocity.y - p.fastFall) * 0.01f,
                      rays.reach);
  rays.nearest = -1;
  rays.nearestDistance = 1e30f;
  for (int i = 0; i < kFloorRays; ++i) {
    rays.distance[i] = 1e30f;
    rays.normal[i] = {0, 1, 0};
  }
  return rays;
}

template <class F>
OBBY_DEVICE BoxT<F> boundsOf(const FloorRaysT<F>& r) {
  const Vec3T<F> e{absf(r.right.x) + absf(r.back.x), 0, absf(r.right.z) + absf(r.back.z)};
  return {r.origin - e - Vec3T<F>{0, r.reach, 0}, r.origin + e};
}

// Records a hit of a ray at `t`. Returns true if no earlier hit was closer.
template <class F>
OBBY_DEVICE MaskOf<F> record(FloorRaysT<F>& rays, int ray, MaskOf<F> hit, F t) {
  const MaskOf<F> closer = hit & (t < rays.distance[ray]);
  rays.distance[ray] = select(closer, t, rays.distance[ray]);
  return closer;
}

template <class F>
OBBY_DEVICE void recordNearest(FloorRaysT<F>& rays, MaskOf<F> hit, F t, int candidate) {
  const MaskOf<F> nearest = hit & (t < rays.nearestDistance);
  rays.nearestDistance = select(nearest, t, rays.nearestDistance);
  rays.nearest = select(nearest, IntOf<F>(candidate), rays.nearest);
}

template <class F>
OBBY_DEVICE void recordTilted(FloorRaysT<F>& rays, int ray, MaskOf<F> hit, F t, Vec3T<F> normal,
                              int candidate) {
  rays.tilted = true;
  rays.normal[ray] = select(record(rays, ray, hit, t), normal, rays.normal[ray]);
  recordNearest(rays, hit, t, candidate);
}

// Casts the rays at an upright block. A hit is on its top face, below the origin and inside the
// rectangle.
template <class F>
OBBY_DEVICE void castAtUpright(FloorRaysT<F>& rays, const geom::BlockT<F>& block, int index,
                               MaskOf<F> asked) {
  const F t = rays.origin.y - (block.pose.position.y + block.half.y);
  const MaskOf<F> met = asked & (t >= 0.0f) & (t <= rays.reach);
  if (!any(met)) return;
  const Mat3T<F>& r = block.pose.rotation;
  const Vec3T<F> half = block.half, d = rays.origin - block.pose.position;
  const F x = dot(d, r.x), z = dot(d, r.z);
  const F xr = dot(rays.right, r.x), zr = dot(rays.right, r.z);
  const F xb = dot(rays.back, r.x), zb = dot(rays.back, r.z);
  // Well inside a large floor all rays hit; the margin is far above rounding.
  const MaskOf<F> inside = (absf(x) + absf(xr) + absf(xb) < half.x - 0.01f) &
                           (absf(z) + absf(zr) + absf(zb) < half.z - 0.01f);
  const bool allInside = !any(met & !inside);
  MaskOf<F> some = false;
  for (int i = 0; i < kFloorRays; ++i) {
    MaskOf<F> hit = met;
    if (!allInside) {
      const F lx = x + rayRight(i) * xr + rayBack(i) * xb;
      const F lz = z + rayRight(i) * zr + rayBack(i) * zb;
      hit = met & (absf(lx) <= half.x) & (absf(lz) <= half.z);
    }
    some = some | hit;
    const MaskOf<F> closer = record(rays, i, hit, t);
    if (rays.tilted) rays.normal[i] = select(closer, Vec3T<F>{0, 1, 0}, rays.normal[i]);
  }
  recordNearest(rays, some, t, index);
}

// Casts the rays at a block with any rotation. Uses the slabs of geom/shapes/block.h, and computes
// the shared values of the rays once.
template <class F>
OBBY_DEVICE void castAtTilted(FloorRaysT<F>& rays, const geom::BlockT<F>& block, int index,
                              MaskOf<F> asked) {
  const Mat3T<F>& r = block.pose.rotation;
  const Vec3T<F> half = block.half;
  const Vec3T<F> down = {-r.x.y, -r.y.y, -r.z.y};
  const Vec3T<F> inverse{1.0f / geom::awayFromZero(down.x), 1.0f / geom::awayFromZero(down.y),
                         1.0f / geom::awayFromZero(down.z)};
  const Vec3T<F> origin = toLocal(block.pose, rays.origin);
  const Vec3T<F> right = toLocal(r, rays.right), back = toLocal(r, rays.back);
  const Vec3T<F> nx = select(down.x < 0.0f, r.x, -r.x), ny = select(down.y < 0.0f, r.y, -r.y),
                 nz = select(down.z < 0.0f, r.z, -r.z);
  for (int i = 0; i < kFloorRays; ++i) {
    const Vec3T<F> from = origin + right * rayRight(i) + back * rayBack(i);
    const Vec3T<F> a = mul(-half - from, inverse), b = mul(half - from, inverse);
    const Vec3T<F> first = min(a, b), last = max(a, b);
    F enter = first.x;
    Vec3T<F> normal = nx;
    const MaskOf<F> byY = first.y > enter;
    enter = select(byY, first.y, enter);
    normal = select(byY, ny, normal);
    const MaskOf<F> byZ = first.z > enter;
    enter = select(byZ, first.z, enter);
    normal = select(byZ, nz, normal);
    const F leave = minf(minf(last.x, last.y), last.z);
    const MaskOf<F> hit = asked & (enter >= 0.0f) & (enter <= leave) & (enter <= rays.reach);
    recordTilted(rays, i, hit, enter, normal, index);
  }
}

// Casts the rays at any shape, for one world.
OBBY_DEVICE void castAt(FloorRaysT<float>& rays, const Pose& pose, const level::Collider& collider,
                        int index) {
  const Vec3 down = toLocal(pose.rotation, Vec3{0, -1, 0});
  const Vec3 origin = toLocal(pose, rays.origin);
  const Vec3 right = toLocal(pose.rotation, rays.right), back = toLocal(pose.rotation, rays.back);
  geom::visitShape(collider.kind, [&](auto shape) {
    for (int i = 0; i < kFloorRays; ++i) {
      const Vec3 from = origin + right * rayRight(i) + back * rayBack(i);
      geom::RayHit hit{};
      if (!decltype(shape)::castRay(collider.shape, from, down, rays.reach, hit)) continue;
      recordTilted(rays, i, true, hit.t, pose.rotation * hit.normal, index);
    }
  });
}

// Returns the average of the rays that hit. The caller adds friction and motion of the surface.
template <class F>
OBBY_DEVICE FloorT<F> averageOf(const FloorRaysT<F>& rays, const Params& p) {
  FloorT<F> floor;
  F sum = 0, hits = 0;
  Vec3T<F> normal;
  for (int i = 0; i < kFloorRays; ++i) {
    const MaskOf<F> hit = rays.distance[i] <= rays.reach;
    sum += select(hit, rays.distance[i], F(0.0f));
    hits += select(hit, F(1.0f), F(0.0f));
    if (rays.tilted) normal += select(hit, rays.normal[i], Vec3T<F>{});
  }
  if (!rays.tilted) normal.y = hits;
  floor.sensed = rays.nearest >= 0;
  floor.nearest = rays.nearest;
  const F share = 1.0f / select(floor.sensed, hits, F(1.0f));
  floor.gap = select(floor.sensed, sum * share - rayHeight(p), F(0.0f));
  floor.normal = select(floor.sensed, normal * share, Vec3T<F>{0, 1, 0});
  return floor;
}

// Adds the velocity and the turning of the surface under the player.
OBBY_DEVICE void surfaceMotion(const World& w, const RigidBody* bodies,
                               const level::LevelView& level, const Candidate& c, Floor& floor) {
  const level::Collider& collider = level.colliders[c.collider];
  if (c.flags & level::kDynamic) {
    const RigidBody& body = bodies[collider.body];
    floor.velocity += velocityAt(body, w.position);
    floor.turning = body.spin.y;
  }
  if (c.flags & level::kConveyor) {
    floor.velocity += conveyorVelocityAt(level.roles[collider.role], c.pose->position, w.position);
  }
  if (c.flags & level::kCarries) {
    // The displacement of the part's point that was under the player a tick ago.
    const Pose before = poseOf(level.movers[collider.mover], w, 0);
    const Vec3 local = toLocal(before, w.position);
    const float rate = float(level.params.controlRate);
    floor.velocity += (toWorld(*c.pose, local) - w.position) * rate;
    const Vec3 turned = toLocal(before.rotation, Vec3{1, 0, 0});
    floor.turning = -(c.pose->rotation * turned).z * rate;  // sine of the angle turned in a tick
  }
}

// Returns the column that rays can reach at any facing, before the rays are made. Most ticks in the
// air end with this test. Lanes skip it, so it must cover every hit of a ray, with a margin for
// rounding.
OBBY_DEVICE Box columnOf(const World& w, const Params& p) {
  constexpr float kMargin = 0.25f;  // studs; above the rounding of any position
  const float side = (p.bodyWidth + p.bodyDepth) * p.floorRaySpread + kMargin;
  const float fall = maxf(0.0f, -w.velocity.y) * (p.tickSeconds + 0.01f);
  const float reach = p.floorReachBase * p.rootHeight + farthestFloor(p) * p.hipHeight;
  const float top = rayHeight(p), below = maxf(reach, top) + fall + kMargin;
  return {w.position + Vec3{-side, top - below, -side},
          w.position + Vec3{side, top + kMargin, side}};
}

OBBY_DEVICE bool hasFloorBelow(const World& w, const Params& p, const Candidates& near) {
  if (!(near.anyFlags & level::kSolid)) return false;
  const Box column = columnOf(w, p);
  bool found = false;
  for (int k = 0; k < near.count; ++k) {
    found |= (near.items[k].flags & level::kSolid) && overlaps(near.items[k].bounds, column);
  }
  return found;
}

// Casts the rays at the solid parts below.
OBBY_DEVICE FloorRaysT<float> castFloor(const Player& player, const level::LevelView& level,
                                        const Candidates& near) {
  FloorRaysT<float> rays = makeRays(player, level.params);
  const Box box = boundsOf(rays);
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if (!(c.flags & level::kSolid) || !overlaps(c.bounds, box)) continue;
    const level::Collider& collider = level.colliders[c.collider];
    if (!(c.flags & level::kBlock)) {
      castAt(rays, *c.pose, collider, k);
    } else if (c.flags & level::kUpright) {
      castAtUpright<float>(rays, {*c.pose, collider.shape.half}, k, true);
    } else {
      castAtTilted<float>(rays, {*c.pose, collider.shape.half}, k, true);
    }
  }
  return rays;
}

OBBY_DEVICE Floor senseFloor(const World& w, const RigidBody* bodies, const Player& player,
                             const level::LevelView& level, const Candidates& near) {
  if (!hasFloorBelow(w, level.params, near)) return {};
  const FloorRaysT<float> rays = castFloor(player, level, near);
  if (rays.nearest < 0) return {};
  Floor floor = averageOf(rays, level.params);
  const Candidate& nearest = near.items[rays.nearest];
  floor.grip = level.colliders[nearest.collider].grip;
  floor.body = level.colliders[nearest.collider].body;
  surfaceMotion(w, bodies, level, nearest, floor);
  return floor;
}

}  // namespace obby::sim
