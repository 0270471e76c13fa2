// Poses of a part, sample by sample, in the page data's format.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace obby::view {

struct Poses {
  std::vector<float> positions;    // (count x 3), studs
  std::vector<int16_t> rotations;  // (count x 4), quaternion x 32767

  void add(Vec3 position, Quat q) {
    positions.insert(positions.end(), {position.x, position.y, position.z});
    for (const float v : {q.x, q.y, q.z, q.w}) {
      rotations.push_back(int16_t(std::lround(clampf(v, -1.0f, 1.0f) * 32767)));
    }
  }
  size_t bytes() const { return positions.size() * 4 + rotations.size() * 2; }
};

}  // namespace obby::view
