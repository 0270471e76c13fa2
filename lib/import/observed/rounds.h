// Finds the period of repeating poses, one per frame.
#pragma once

#include <cstddef>
#include <vector>

#include "math/vec.h"

namespace obby::importer {

struct Round {
  size_t frames = 0;   // period, rounded; 0: the poses do not repeat
  double seconds = 0;  // exact period
  size_t begin = 0;    // first frame of the repetition
};

// Returns the smallest period with two complete rounds in the poses.
Round roundIn(const std::vector<Pose>& poses);

}  // namespace obby::importer
