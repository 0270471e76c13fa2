// Contacts with slopes: they turn speed, and never add energy (docs/proof.md, slopes). Energies are
// given as the heights to which they would lift a body.
#include <algorithm>

#include "solve/proof/reach_bound.h"

namespace obby::solve {

// Energy of a flight, without what keys add on slopes until it lands.
float ReachBound::base(uint32_t support, const Flight& f) const {
  const float walk = limits_.walk, g = 2 * p_.gravity;
  const float came = bases_[support];
  if (supports_[support].tilted && !f.leaps) return std::max(came, apex(fall(support)) - slopeGain());
  // Speed sideways that is left from the flight before, where a floor brakes it first.
  const float high = came + slopeGain() - supports_[support].top;
  const float speed = sqrtf32(walk * walk + g * std::max(high, 0.0f)) - walk;
  const float brake = f.leaps ? limits_.brake : limits_.brakeOnce;
  const float fast = walk + std::max(given_, slopes_ ? speed - brake : 0.0f);
  const float energy = apex(f) + (fast * fast - walk * walk) / g;
  return f.leaps ? energy : std::max(came, energy);
}

// What walking, and keys that push a body up along slopes while it rises, add to that.
float ReachBound::slopeGain() const {
  const float g = p_.gravity, walk = limits_.walk + given_;
  return walk * walk / (2 * g) + 2 * p_.airAccel * walk * tossed_ / (g * g);
}

// Studs/s upward, of a body that leaves a slope.
float ReachBound::slopeToss(uint32_t support) const {
  const Support& s = supports_[support];
  const float g = p_.gravity, walk = limits_.walk + given_;
  const float kept = p_.airAccel * walk / g;  // the rise that keys can keep up on a slope
  const float least = s.top + (walk * walk + 4 * kept * kept) / (2 * g);
  const float head = std::max(bases_[support] + slopeGain(), least);
  const float from = s.tilted ? s.top + s.lift + takeOff_[support] : s.box.lo.y - p_.bodyTop;
  return sqrtf32(2 * g * std::max(head - from, 0.0f));
}

// Studs/s beyond walking.
float ReachBound::slopeSideways(uint32_t support) const {
  const Support& s = supports_[support];
  const float head = apex(fall(support)), walk = limits_.walk + given_;
  const float deep = std::max(head - (s.box.lo.y - p_.bodyTop), 0.0f);
  return std::max(sqrtf32(walk * walk + 2 * p_.gravity * deep) - limits_.walk, s.sideways);
}

}  // namespace obby::solve
