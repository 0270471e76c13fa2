// What the player stands on: seven rays straight down around the root, three on the centre line and
// four at the corners, averaged over those that hit (docs/physics.md, floor).
#pragma once

#include "geom/shapes/table.h"
#include "sim/candidates.h"

namespace obby::sim {

constexpr int kFloorRays = 7;

struct Floor {
  bool sensed = false;
  float gap = 0;  // studs from the feet down to the floor; negative: the floor is above the feet
  Vec3 normal{0, 1, 0};  // average, not normalised
  Vec3 velocity;         // of the surface where the player stands, studs/s
  float turning = 0;     // rad/s of a carrying floor about Y
  float friction = 0;    // of the nearest floor
};

struct FloorRays {
  Vec3 origin;       // centre ray, world
  Vec3 right, back;  // corner offsets, world
  float reach;       // studs below the origin line
  float distance[kFloorRays];
  int nearest = -1;  // candidate of the shortest ray
  float nearestDistance;
};

// Offsets of the rays in units of (right, back).
OBBY_DEVICE float rayRight(int i) { return i < 3 ? float(i - 1) : (i & 1) ? -1.0f : 1.0f; }
OBBY_DEVICE float rayBack(int i) { return i < 3 ? 0.0f : i < 5 ? -1.0f : 1.0f; }

// Height of the rays' origins above the feet.
OBBY_DEVICE float rayHeight(const Params& p) {
  return p.hipHeight + p.rootHeight * 0.5f - p.floorRayStart * p.rootHeight;
}

OBBY_DEVICE FloorRays makeRays(const World& w, const Params& p) {
  const SinCos yaw = sinCos(w.yaw);
  FloorRays rays;
  rays.origin = w.position + Vec3{0, rayHeight(p), 0};
  const float x = p.bodyWidth * p.floorRaySpread, z = p.bodyDepth * p.floorRaySpread;
  rays.right = {yaw.cos * x, 0, -yaw.sin * x};
  rays.back = {yaw.sin * z, 0, yaw.cos * z};
  const float hysteresis = (w.flags & kFloorSensed) ? p.floorKeep : p.floorAcquire;
  rays.reach = p.floorReachBase * p.rootHeight + hysteresis * p.hipHeight;
  // A fast fall looks ahead by what the next tick will cover, so that no thin floor slips between
  // two ticks.
  const float fall = -w.velocity.y * p.tickSeconds;
  const float seen = rays.reach - rayHeight(p);
  if (fall > seen) rays.reach += fall - seen;
  if (w.velocity.y < -p.fastFall) rays.reach += (-w.velocity.y - p.fastFall) * 0.01f;
  rays.nearestDistance = 1e30f;
  for (int i = 0; i < kFloorRays; ++i) rays.distance[i] = 1e30f;
  return rays;
}

// Where rays can go at any facing, before they are made: most ticks in the air end here.
OBBY_DEVICE Box columnOf(const World& w, const Params& p) {
  const float side = (p.bodyWidth + p.bodyDepth) * p.floorRaySpread;
  const float fall = maxf(0.0f, -w.velocity.y) * (p.tickSeconds + 0.01f);
  const float below = p.floorReachBase * p.rootHeight + p.floorKeep * p.hipHeight + fall;
  const float top = rayHeight(p);
  return {w.position + Vec3{-side, top - below, -side}, w.position + Vec3{side, top, side}};
}

OBBY_DEVICE bool hasFloorBelow(const World& w, const Params& p, const Candidates& near) {
  if (!(near.anyFlags & level::kSolid)) return false;
  const Box column = columnOf(w, p);
  bool any = false;
  for (int k = 0; k < near.count; ++k) {
    any |= (near.items[k].flags & level::kSolid) && overlaps(near.items[k].bounds, column);
  }
  return any;
}

OBBY_DEVICE Box boundsOf(const FloorRays& r) {
  const Vec3 e{absf(r.right.x) + absf(r.back.x), 0, absf(r.right.z) + absf(r.back.z)};
  return {r.origin - e - Vec3{0, r.reach, 0}, r.origin + e};
}

OBBY_DEVICE void record(FloorRays& rays, int ray, float t, int candidate) {
  rays.distance[ray] = minf(rays.distance[ray], t);
  if (t < rays.nearestDistance) {
    rays.nearestDistance = t;
    rays.nearest = candidate;
  }
}

// Rays against a block that stands upright: a hit is a top face below the origin, inside the
// rectangle.
OBBY_DEVICE void castAtUpright(FloorRays& rays, const Candidate& c, Vec3 half, int index) {
  const float t = rays.origin.y - (c.pose->position.y + half.y);
  if (t < 0 || t > rays.reach) return;
  const Mat3& r = c.pose->rotation;
  const Vec3 d = rays.origin - c.pose->position;
  const float x = dot(d, r.x), z = dot(d, r.z);
  const float xr = dot(rays.right, r.x), zr = dot(rays.right, r.z);
  const float xb = dot(rays.back, r.x), zb = dot(rays.back, r.z);
  // Well inside a large floor all rays hit; the margin is far above rounding.
  if (absf(x) + absf(xr) + absf(xb) < half.x - 0.01f &&
      absf(z) + absf(zr) + absf(zb) < half.z - 0.01f) {
    for (int i = 0; i < kFloorRays; ++i) rays.distance[i] = minf(rays.distance[i], t);
    if (t < rays.nearestDistance) {
      rays.nearestDistance = t;
      rays.nearest = index;
    }
    return;
  }
  for (int i = 0; i < kFloorRays; ++i) {
    const float lx = x + rayRight(i) * xr + rayBack(i) * xb;
    const float lz = z + rayRight(i) * zr + rayBack(i) * zb;
    if (absf(lx) <= half.x && absf(lz) <= half.z) record(rays, i, t, index);
  }
}

OBBY_DEVICE void castAt(FloorRays& rays, const Candidate& c, const level::Collider& collider,
                        int index, Vec3* normals) {
  const Vec3 down = toLocal(c.pose->rotation, Vec3{0, -1, 0});
  const Vec3 origin = toLocal(*c.pose, rays.origin);
  const Vec3 right = toLocal(c.pose->rotation, rays.right),
             back = toLocal(c.pose->rotation, rays.back);
  geom::visitShape(collider.kind, [&](auto shape) {
    for (int i = 0; i < kFloorRays; ++i) {
      const Vec3 from = origin + right * rayRight(i) + back * rayBack(i);
      geom::RayHit hit{};
      if (!decltype(shape)::castRay(collider.shape, from, down, rays.reach, hit)) continue;
      if (hit.t >= rays.distance[i]) continue;
      record(rays, i, hit.t, index);
      normals[i] = c.pose->rotation * hit.normal;
    }
  });
}

// Velocity of what the player stands on, and its turning.
OBBY_DEVICE void surfaceMotion(const World& w, const level::LevelView& level, const Candidate& c,
                               Floor& floor) {
  const level::Collider& collider = level.colliders[c.collider];
  floor.friction = collider.friction;
  if (c.flags & level::kConveyor) {
    const level::Roles& r = level.roles[collider.role];
    floor.velocity += r.conveyorVelocity + cross(r.conveyorAngular, w.position - r.conveyorCenter);
  }
  if (c.flags & level::kCarries) {
    // From where the point under the player was a tick ago.
    const Pose before = moverPose(level.movers[collider.mover], w.tick);
    const Vec3 local = toLocal(before, w.position);
    const float rate = float(level.params.controlRate);
    floor.velocity += (toWorld(*c.pose, local) - w.position) * rate;
    const Vec3 turned = toLocal(before.rotation, Vec3{1, 0, 0});
    floor.turning = -(c.pose->rotation * turned).z * rate;  // sine of the angle a tick turns
  }
}

OBBY_DEVICE Floor senseFloor(const World& w, const level::LevelView& level,
                             const Candidates& near) {
  Floor floor;
  if (!hasFloorBelow(w, level.params, near)) return floor;
  FloorRays rays = makeRays(w, level.params);
  const Box box = boundsOf(rays);
  Vec3 normals[kFloorRays];
  for (int i = 0; i < kFloorRays; ++i) normals[i] = {0, 1, 0};
  for (int k = 0; k < near.count; ++k) {
    const Candidate& c = near.items[k];
    if (!(c.flags & level::kSolid) || !overlaps(c.bounds, box)) continue;
    const level::Collider& collider = level.colliders[c.collider];
    if (c.flags & level::kUpright) {
      castAtUpright(rays, c, collider.shape.half, k);
    } else {
      castAt(rays, c, collider, k, normals);
    }
  }
  if (rays.nearest < 0) return floor;
  float sum = 0, hits = 0;
  Vec3 normal;
  for (int i = 0; i < kFloorRays; ++i) {
    if (rays.distance[i] > rays.reach) continue;
    sum += rays.distance[i];
    hits += 1;
    normal += normals[i];
  }
  floor.sensed = true;
  floor.gap = sum / hits - rayHeight(level.params);
  floor.normal = normal * (1.0f / hits);
  surfaceMotion(w, level, near.items[rays.nearest], floor);
  return floor;
}

}  // namespace obby::sim
