// Finds a turn about an axis at constant speed in a list of poses, one per frame.
#pragma once

#include <optional>
#include <vector>

#include "import/draft/draft.h"

namespace obby::importer {

struct SteadyTurn {
  Vec3 axis;  // unit, in the part's frame
  double speed = 0;
  // The point of the part's frame that stays in place, or nullopt if the part moves as it turns.
  std::optional<Vec3> pivot;
  size_t begin = 0;  // the last frame before it turns
  double since = 0;  // seconds; when it left the rotation of frame `begin`
};

// Returns a turn that goes on to the last frame. Steps of up to `longestGap` frames count as
// smooth.
std::optional<SteadyTurn> steadyTurnIn(const std::vector<Pose>& poses, size_t longestGap);

}  // namespace obby::importer
