#include "gen/reach.h"

#include "math/vec.h"

namespace obby::gen {

namespace {

// Gravity is clamped to this value, studs/s^2, since levels with almost no gravity would be
// millions of studs long.
constexpr float kMinGravity = 4;
constexpr float kMaxRise = 120, kMaxGap = 200;  // studs
constexpr float kLegsUsed = 0.9f;  // share of the hip height; higher floors hit the torso
constexpr int kDelays = 4;         // samples of a jump's delay within the coyote time
constexpr float kDeepest = -20;    // studs: the deepest drop of any style's gap

}  // namespace

float Reach::legs() const { return kLegsUsed * p_.hipHeight; }
float Reach::gravity() const { return maxf(p_.gravity, kMinGravity); }

bool Reach::cut() const {
  return p_.gravity < kMinGravity || rise() >= kMaxRise || widest() >= kMaxGap;
}

float Reach::riseFrom(float upward) const {
  return minf(riseOfLaunch(p_, gravity(), upward) + legs(), kMaxRise);
}

float Reach::apex() const { return maxf(rise() - legs(), 0.5f); }

float Reach::gap(float rise) const {
  const float g = gravity(), v = p_.jumpSpeed;
  float best = -1;
  for (int i = 0; i <= kDelays; ++i) {
    const float delay = p_.coyoteTime * float(i) / float(kDelays);
    const float height = rise - legs() + 0.5f * g * delay * delay;
    const float end2 = 2 * g * (riseOfLaunch(p_, g, v) - height);
    if (end2 < 0) continue;
    const float seconds = delay + p_.substepSeconds + (v + sqrtf32(end2)) / g;
    best = maxf(best, p_.walkSpeed * seconds);
  }
  if (best < 0) return 0;
  return minf(best + 2 * p_.floorRaySpread * p_.bodyDepth, kMaxGap);
}

float Reach::widest() const { return gap(kDeepest); }

float Reach::walkedGap() const {
  const float seconds = sqrtf32(2 * legs() / gravity());
  return minf(p_.walkSpeed * seconds + 2 * p_.floorRaySpread * p_.bodyDepth, kMaxGap);
}

float Reach::speedFor(float height) const { return sqrtf32(2 * gravity() * maxf(height, 0.0f)); }
float Reach::flight() const { return 2 * p_.jumpSpeed / gravity() + p_.coyoteTime; }

}  // namespace obby::gen
