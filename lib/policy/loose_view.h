// Inputs about the nearest dynamic body, which the player may have to push. In the maps it looks
// like any floor, and it may be far outside them.
#pragma once

#include "level/level_view.h"
#include "policy/frame.h"
#include "sim/loose.h"

namespace obby::policy {

constexpr float kNear = 8;  // studs, or studs/s, at which an input reaches half its range

// Position and velocity of the body, all zero if there is none.
constexpr int kLooseInputs = 6;
OBBY_DEVICE void tellLoose(const level::LevelView& level, const sim::World& w,
                           const sim::LooseBody* loose, const Frame& frame, float* out) {
  const sim::LooseBody* nearest = nullptr;
  float least = 1e9f;
  for (uint32_t i = 0; i < level.looseCount; ++i) {
    if (loose[i].state == sim::LooseState::gone) continue;
    const Vec3 to = loose[i].position - w.position;
    if (!(dot(to, to) < least)) continue;
    least = dot(to, to);
    nearest = &loose[i];
  }
  for (int i = 0; i < kLooseInputs; ++i) out[i] = 0;
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
