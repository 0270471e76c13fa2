// How far above a floor somebody may jump, or fall anew, who falls onto it fast: the legs feel it
// from afar, and such as are strongly damped and little stiff brake all of the fall up there.
#pragma once

#include <algorithm>

#include "solve/proof/felt_floor.h"

namespace obby::solve {

// Ticks of being Landed.
inline int landedTicksOf(const Params& p) {
  return (int(p.landedSteps) + int(p.substeps) - 1) / int(p.substeps);
}

class BrakedFall {
 public:
  explicit BrakedFall(const Params& p) : p_(p), kept_(feltAtRest(p)) {}

  // Studs from the floor up to the feet as they have been Landed for long enough to jump, or up to
  // where somebody at rest is who falls no sooner than they do. 0: no more than the legs keep
  // anybody above a floor.
  float highest() const {
    float most = 0;
    forFalls([&](float gap, float fall) { most = std::max(most, leftOf(gap, fall)); });
    return most > 0 ? most + kBetween : 0.0f;
  }

  // Squared: the speed upward, as if from the floor, of whom one that goes up at `floorSpeed` turns
  // back up in the tick that first feels it. 0: nobody above where the legs keep them, or legs so
  // stiff that the floor's own speed leads higher.
  float turnedUp(float floorSpeed) const {
    if (!(p_.hoverDamping * floorSpeed > p_.hoverStiffness * kept_)) return 0;
    if (p_.hoverStiffness * floorSpeed >= 2 * p_.gravity * p_.hoverDamping) return 0;
    float most = 0;
    forFalls([&](float gap, float fall) {
      float speed = -fall;
      pass(gap, speed, true, floorSpeed);
      if (!(speed > 0 && gap > kept_)) return;
      most = std::max(most, speed * speed + 2 * p_.gravity * (gap + kBetween));
    });
    return most;
  }

 private:
  static constexpr int kSpeeds = 128, kGaps = 32;
  static constexpr float kBetween = 0.4f;  // studs: what is between two that are tried

  template <class Look>
  void forFalls(Look&& look) const {
    for (int i = 1; i <= kSpeeds; ++i) {
      const float fall = p_.maxFallSpeed * (float(i) / kSpeeds), farthest = feltInFall(p_, fall);
      for (int k = 1; k <= kGaps; ++k) look(farthest * (float(k) / kGaps), fall);
    }
  }

  // A tick. `felt`: the floor, which goes up at `floorSpeed`.
  void pass(float& gap, float& speed, bool felt, float floorSpeed) const {
    for (int s = 0; s < int(p_.substeps); ++s) {
      const float lift = -p_.hoverStiffness * gap - p_.hoverDamping * (speed - floorSpeed);
      const float a = felt ? std::clamp(lift, -p_.gravity, p_.hoverLimit) : -p_.gravity;
      gap += speed * p_.substepSeconds + a * (0.5f * p_.substepSeconds * p_.substepSeconds);
      speed += a * p_.substepSeconds;
    }
  }

  // From where somebody at rest is on the legs as late as who is there so fast after the tick that
  // first feels the floor; flights are granted some of that time. 0: from where the legs keep them.
  float restAt(float gap, float fall) const {
    const float end = sqrtf32(fall * fall + 2 * p_.gravity * std::max(gap - kept_, 0.0f));
    const float late = (end - fall) / p_.gravity - p_.coyoteTime - p_.tickSeconds;
    return late > 0 ? kept_ + 0.5f * p_.gravity * late * late : 0.0f;
  }

  // Of that gap, after the tick that first feels the floor and those of being Landed, or rather
  // from where it is as long a fall; 0: no more than the legs keep.
  float leftOf(float gap, float fall) const {
    float speed = -fall, rest = 0;
    for (int tick = 0; tick <= landedTicksOf(p_); ++tick) {
      if (!(gap > kept_)) return rest;  // on the legs
      pass(gap, speed, gap <= feltInFall(p_, -speed), 0);
      if (tick == 0 && gap > kept_) rest = restAt(gap, -speed);
    }
    return gap > kept_ ? std::max(gap, rest) : rest;
  }

  const Params& p_;
  const float kept_;  // studs below the feet, at rest
};

}  // namespace obby::solve
