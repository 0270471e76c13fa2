#include "train/guide.h"

#include <algorithm>

namespace obby::train {

namespace {

// A stud beside the line counts as so many along it: there may be nothing to walk on. Where the way
// turns back, its other lane must not look near.
constexpr float kOff = 3;

}  // namespace

Guide::Guide(std::vector<Vec3> places) : places_(std::move(places)), behind_(places_.size(), 0) {
  for (size_t i = places_.size() - 1; i-- > 0;) {
    behind_[i] = behind_[i + 1] + length(places_[i + 1] - places_[i]);
  }
}

float Guide::left(Vec3 from) const {
  float least = 1e30f;
  for (size_t i = 0; i + 1 < places_.size(); ++i) {
    const Vec3 along = places_[i + 1] - places_[i], to = from - places_[i];
    const float squared = dot(along, along);
    const float share = squared > 0 ? std::clamp(dot(to, along) / squared, 0.0f, 1.0f) : 0;
    const float off = length(to - along * share);
    least =
        std::min(least, kOff * off + behind_[i + 1] + (behind_[i] - behind_[i + 1]) * (1 - share));
  }
  return least;
}

}  // namespace obby::train
