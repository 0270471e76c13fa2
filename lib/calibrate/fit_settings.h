// How a fit searches.
#pragma once

#include <cstdint>
#include <span>

#include "calibrate/work.h"

namespace obby::calibrate {

struct FitSettings {
  uint64_t seed = 1;
  uint32_t restarts = 3;       // searches, one after another, each from a place of its own
  uint32_t population = 32;    // of each
  uint32_t generations = 100;  // of each, at most
  // The searches go by short windows, in which one early miss hides nothing; what they find is
  // refined on longer ones, to which an error of a single sample matters less.
  ObjectiveSettings objective;
  double longSeconds = 1.5;
  // Studs. The search goes on no longer once takes that play to their ends are off by no more, on
  // average: those held out, or all where none is. 0: it goes on to its end.
  double tolerance = 0;
  std::span<const Take> heldOut = {};
};

}  // namespace obby::calibrate
