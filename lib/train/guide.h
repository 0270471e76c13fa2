// A way through a level as a line of places: how much of it is left from anywhere. For rewards
// only; the policy never sees it.
#pragma once

#include <vector>

#include "math/vec.h"

namespace obby::train {

class Guide {
 public:
  explicit Guide(std::vector<Vec3> places);  // at least two

  // Studs to the end: thrice those to the line, then along it. The least over all of the line, so
  // that short cuts count, once they come near to it again.
  float left(Vec3 from) const;
  float studs() const { return behind_.front(); }  // of the whole way

 private:
  std::vector<Vec3> places_;
  std::vector<float> behind_;  // (places), studs from each place to the end
};

}  // namespace obby::train
