// A route through a level as a polyline, with the length left from any position. Only rewards use
// it; the policy never sees it.
#pragma once

#include <span>
#include <vector>

#include "train/guide_view.h"

namespace obby::train {

class Guide {
 public:
  // `places`: at least two. `waypoints`: those of the query. Each waypoint maps to the nearest
  // place that is not before the previous waypoint's place.
  explicit Guide(std::vector<Vec3> places, std::span<const Vec3> waypoints = {});

  // Like the functions of GuideView.
  float left(Vec3 position, float from, uint32_t waypoints) const {
    return view().left(position, from, waypoints);
  }
  float studs() const { return view().studs(); }

  // Valid while this object lives and does not move.
  GuideView view() const {
    return {places_.data(), behind_.data(), stops_.data(), uint32_t(places_.size()),
            uint32_t(stops_.size())};
  }

 private:
  std::vector<Vec3> places_;
  std::vector<float> behind_;    // (places), studs from each place to the end
  std::vector<uint32_t> stops_;  // (waypoints), index of each waypoint's place
};

}  // namespace obby::train
