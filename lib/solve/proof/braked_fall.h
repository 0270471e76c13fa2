// How far above a floor somebody may jump who falls onto it fast: the legs feel it from afar, and
// such as are strongly damped and little stiff brake all of the fall up there.
#pragma once

#include <algorithm>

#include "sim/floor.h"

namespace obby::solve {

class BrakedFall {
 public:
  explicit BrakedFall(const Params& p)
      : p_(p),
        kept_(p.floorReachBase * p.rootHeight + farthestFloor(p) * p.hipHeight -
              sim::rayHeight(p)) {}

  // Studs from the floor up to the feet as they have been Landed for long enough to jump. 0: no
  // more than the legs keep anybody above a floor.
  float highest() const {
    float most = 0;
    for (int i = 1; i <= kSpeeds; ++i) {
      const float fall = p_.maxFallSpeed * (float(i) / kSpeeds), look = lookAt(fall);
      for (int k = 1; k <= kGaps; ++k) {
        most = std::max(most, leftOf(look * (float(k) / kGaps), fall));
      }
    }
    return most > 0 ? most + kBetween : 0.0f;
  }

 private:
  static constexpr int kSpeeds = 32, kGaps = 16;
  static constexpr float kBetween = 0.4f;  // studs: what is between two that are tried

  // How far below the feet a floor is felt by somebody who falls, studs.
  float lookAt(float fall) const {
    return std::max(kept_, fall * p_.tickSeconds) + std::max(fall - p_.fastFall, 0.0f) * 0.01f;
  }

  // Of that gap, after the tick that first feels the floor and those of being Landed; 0: no more
  // than the legs keep.
  float leftOf(float gap, float fall) const {
    float speed = -fall;
    for (int tick = 0; tick <= int(p_.landedTicks); ++tick) {
      if (!(gap > kept_)) return 0;  // on the legs
      const bool felt = gap <= lookAt(-speed);
      for (int s = 0; s < int(p_.substeps); ++s) {
        const float lift = -p_.hoverStiffness * gap - p_.hoverDamping * speed;
        const float a = felt ? std::clamp(lift, -p_.gravity, p_.hoverLimit) : -p_.gravity;
        gap += speed * p_.substepSeconds + a * (0.5f * p_.substepSeconds * p_.substepSeconds);
        speed += a * p_.substepSeconds;
      }
    }
    return gap > kept_ ? gap : 0.0f;
  }

  const Params& p_;
  const float kept_;  // studs below the feet, at rest
};

}  // namespace obby::solve
