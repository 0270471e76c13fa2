// Settings of a fit's searches.
#pragma once

#include <cstdint>
#include <span>

#include "calibrate/objective.h"
#include "calibrate/work.h"

namespace obby::calibrate {

struct FitSettings {
  uint64_t seed = 1;
  uint32_t restarts = 3;       // searches, each from its own start
  uint32_t population = 32;    // points per generation
  uint32_t generations = 100;  // max generations of each search
  // The searches use short windows, so that an early miss does not hide later effects. Their result
  // is refined on longer windows, where the error of a single sample matters less.
  ObjectiveSettings objective;
  double longSeconds = 1.5;
  // Studs. The search ends once the mean error of complete playbacks is within it. Held-out takes
  // decide, or all takes if none is held out. 0 disables this.
  double tolerance = 0;
  std::span<const Take> heldOut = {};
};

}  // namespace obby::calibrate
