#include "calibrate/mass_centre_fit.h"

#include <array>
#include <cmath>
#include <set>

#include "calibrate/frame_play.h"

namespace obby::calibrate {

namespace {

constexpr float kMinTurning = 0.02f;  // min sum of squared changes of the facing vector
constexpr float kOffSpeed = 0.01f;    // rounding of speeds, studs/s
constexpr float kOffLimit = 0.02f;    // max error of a sideways gain, studs/s per step
constexpr float kMinTurn2 = 1e-6f;    // min squared change of the facing vector in one frame

bool inFreeFall(const Frame& f) {
  return f.state == sim::State::freefall && (f.facing.x != 0 || f.facing.z != 0);
}

// The root's displacement relative to the centre of mass, which follows the recorded velocities.
struct Swing {
  bool known = false;
  Vec3 root;
};

// Returns the swing between two frames. It is known only if the acceleration is constant: gravity,
// and sideways either none or the maximum.
Swing swingOf(const Frame& a, const Frame& b, const Params& p) {
  if (!inFreeFall(a) || !inFreeFall(b)) return {};
  const float dt = p.substepSeconds;
  const uint32_t steps = stepsBetween(a, b, 1 / double(dt));
  if (steps == 0) return {};
  const float n = float(steps);
  const Vec3 gain = b.velocity - a.velocity;
  if (std::abs(gain.y + p.gravity * dt * n) > kOffSpeed) return {};
  const float side = std::hypot(gain.x, gain.z), max = p.airAccel * dt * n;
  if (side > kOffSpeed && std::abs(side - max) > kOffLimit * n) return {};
  Vec3 out = b.position - a.position - (a.velocity * n + gain * (0.5f * (n + 1))) * dt;
  out.y = 0;
  return {true, out};
}

}  // namespace

MassCentre massCentreOf(std::span<const Track* const> tracks, const Track& without,
                        const Params& params) {
  using Key = std::array<float, 3>;
  const auto keyOf = [](const Frame& f) { return Key{f.velocity.x, f.velocity.y, f.velocity.z}; };
  std::set<Key> own;
  for (const Frame& f : without.frames) own.insert(keyOf(f));
  double turning = 0, ahead = 0, right = 0;
  for (const Track* track : tracks) {
    if (track == &without) continue;
    for (size_t i = 1; i < track->frames.size(); ++i) {
      const Frame &a = track->frames[i - 1], &b = track->frames[i];
      const Vec3 turn = b.facing - a.facing;
      if (dot(turn, turn) < kMinTurn2) continue;
      const Swing swing = swingOf(a, b, params);
      if (!swing.known || own.count(keyOf(a)) + own.count(keyOf(b)) > 0) continue;
      turning += double(dot(turn, turn));
      ahead -= double(dot(turn, swing.root));
      right -= double(dot(rightOf(turn), swing.root));
    }
  }
  if (turning < double(kMinTurning)) return {};
  return {float(ahead / turning), float(right / turning)};
}

}  // namespace obby::calibrate
