// Draws variations of a line that may make it cheaper.
#pragma once

#include "base/random.h"
#include "solve/improve/variation_pool.h"

namespace obby::solve {

// The facts besides the line that the draws depend on.
struct VariationContext {
  bool hasClock;              // parts move or vanish by the clock: variations often keep the timing
  float studsPerTick;         // at walking speed
  const GuidedLines& donors;  // other solutions, of which spans may be taken; outlives the context
};

// Returns the variations to try first: cut corners by different amounts, with and without jumps.
std::vector<Variation> sweep(const GuidedLine& base, const VariationContext& context);

// Returns a random variation.
Variation drawVariation(const GuidedLine& base, const VariationContext& context, Random& random);

}  // namespace obby::solve
