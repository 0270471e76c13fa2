// A way through a level as a line of places: how much of it is left from anywhere. For rewards
// only; the policy never sees it.
#pragma once

#include <vector>

#include "train/guide_view.h"

namespace obby::train {

class Guide {
 public:
  explicit Guide(std::vector<Vec3> places);  // at least two

  // As GuideView.
  float left(Vec3 position, float from = 0) const { return view().left(position, from); }
  float studs() const { return view().studs(); }

  // Valid while this object lives and stays where it is.
  GuideView view() const { return {places_.data(), behind_.data(), uint32_t(places_.size())}; }

 private:
  std::vector<Vec3> places_;
  std::vector<float> behind_;  // (places), studs from each place to the end
};

}  // namespace obby::train
