// How far below a floor a jump can begin.
#pragma once

#include <algorithm>
#include <vector>

#include "solve/proof/body_reach.h"

namespace obby::solve {

// Who falls past an edge is braked by the legs in the tick that feels the floor, falls on without
// it, and may jump up to the coyote time later.
class CoyoteDrop {
 public:
  // `fastest`: of all falls that will be asked for, studs/s.
  CoyoteDrop(const Params& p, float fastest) : p_(p), step_(std::max(fastest, 1.0f) / kSpeeds) {
    float deepest = sim::rayHeight(p);
    for (int i = 0; i <= kSpeeds; ++i) {
      deepest = std::max(deepest, deepestAfter(step_ * float(i)));
      drops_.push_back(deepest + kBetween);
    }
  }

  // Studs from the floor down to the feet, at most.
  float at(float fall) const {
    const int i = int(std::max(fall, 0.0f) / step_) + 1;
    return drops_[size_t(std::min(i, kSpeeds))];
  }

 private:
  static constexpr int kSpeeds = 64, kGaps = 64;
  static constexpr float kBetween = 0.1f;  // studs: what is between two that are tried
  static constexpr int kFiner = 32;        // substeps are cut up where fast bodies meet parts

  float deepestAfter(float fall) const {
    const float under = sim::rayHeight(p_), look = feltInFall(p_, fall);
    const bool cut = cutsInFall(p_, fall, p_.hipHeight) > 1;
    float deepest = 0;
    for (int i = 0; i <= kGaps; ++i) {
      const float gap = (look + under) * (float(i) / kGaps) - under;
      deepest = std::max(deepest, deepestFrom(gap, fall, p_.substeps));
      if (cut) deepest = std::max(deepest, deepestFrom(gap, fall, p_.substeps * kFiner));
    }
    return deepest;
  }

  // One tick on the hover spring, and then none.
  float deepestFrom(float gap, float fall, int substeps) const {
    const float dt = p_.tickSeconds / float(substeps);
    float speed = -fall;
    for (int i = 0; i < substeps; ++i) {
      const float a = std::clamp(-p_.hoverStiffness * gap - p_.hoverDamping * speed, -p_.gravity,
                                 p_.hoverLimit);
      gap += speed * dt + a * (0.5f * dt * dt);
      speed += a * dt;
    }
    const float later = std::max(float(p_.coyoteSteps) * p_.substepSeconds - p_.tickSeconds, 0.0f);
    return std::max(-gap, 0.5f * p_.gravity * later * later - gap - speed * later);
  }

  const Params& p_;
  const float step_;  // studs/s
  std::vector<float> drops_;
};

}  // namespace obby::solve
