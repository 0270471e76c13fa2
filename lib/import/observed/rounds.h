// Poses, a frame each, that come again and again.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec.h"

namespace obby::importer {

struct Round {
  size_t frames = 0;   // the nearest whole number; 0: the poses do not repeat
  double seconds = 0;  // exactly
  size_t begin = 0;    // the first frame from which they repeat
};

// The smallest period of which two rounds were seen.
Round roundIn(const std::vector<Pose>& poses);

}  // namespace obby::importer
