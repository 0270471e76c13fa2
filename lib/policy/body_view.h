// Inputs about the nearest dynamic body, which the player may have to push. In the maps it looks
// like any floor, and it may be far outside them.
#pragma once

#include "level/level_view.h"
#include "policy/frame.h"
#include "sim/rigid_body.h"
#include "sim/world.h"

namespace obby::policy {

constexpr float kNear = 8;  // studs, or studs/s, at which an input reaches half its range

// 1 if there is a body, its position, and its horizontal velocity; all 0 if there is none.
constexpr int kBodyInputs = 6;
OBBY_DEVICE void tellBodies(const level::LevelView& level, const sim::World& w,
                            const sim::RigidBody* bodies, const Frame& frame, float* out) {
  const sim::RigidBody* nearest = nullptr;
  float min = 1e9f;
  for (uint32_t i = 0; i < level.bodyCount; ++i) {
    if (bodies[i].state == sim::RigidBodyState::gone) continue;
    const Vec3 to = bodies[i].position - w.position;
    if (!(dot(to, to) < min)) continue;
    min = dot(to, to);
    nearest = &bodies[i];
  }
  for (int i = 0; i < kBodyInputs; ++i) out[i] = 0;
  if (nearest == nullptr) return;
  const Vec3 to = nearest->position - w.position, velocity = nearest->velocity;
  out[0] = 1;
  out[1] = squashed(dot(to, frame.forward), kNear);
  out[2] = squashed(dot(to, frame.right), kNear);
  out[3] = squashed(to.y, kNear);
  out[4] = squashed(dot(velocity, frame.forward), kNear);
  out[5] = squashed(dot(velocity, frame.right), kNear);
}

}  // namespace obby::policy
