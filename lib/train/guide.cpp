#include "train/guide.h"

#include <algorithm>

namespace obby::train {

Guide::Guide(std::vector<Vec3> places, std::span<const Vec3> waypoints)
    : places_(std::move(places)), behind_(places_.size(), 0) {
  for (size_t i = places_.size() - 1; i-- > 0;) {
    behind_[i] = behind_[i + 1] + length(places_[i + 1] - places_[i]);
  }
  auto from = places_.begin();
  for (const Vec3 waypoint : waypoints) {
    from = std::min_element(from, places_.end(), [&](Vec3 a, Vec3 b) {
      return length(a - waypoint) < length(b - waypoint);
    });
    stops_.push_back(uint32_t(from - places_.begin()));
  }
}

}  // namespace obby::train
