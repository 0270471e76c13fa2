// Draws variations of a line that may make it cheaper.
#pragma once

#include "base/random.h"
#include "solve/improve/variation_trials.h"

namespace obby::solve {

// The facts besides the line that the draws depend on.
struct VariationContext {
  bool hasClock;       // parts move or vanish by the clock: variations often keep the timing
  float studsPerTick;  // at walking speed
};

// Returns the variations to try first: cut corners by different amounts, with and without jumps.
std::vector<Variation> sweep(const Line& line, const VariationContext& context);

// Returns a random variation.
Variation drawVariation(const Line& line, const VariationContext& context, Random& random);

}  // namespace obby::solve
