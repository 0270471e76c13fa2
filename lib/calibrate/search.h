// The global searches of a fit: CMA-ES over all parameters with an effect, with restarts.
#pragma once

#include "calibrate/fit_settings.h"
#include "calibrate/found.h"

namespace obby::calibrate {

constexpr double kNoLoss = 1e-6;  // studs^2: below any recorder's precision

// Pass 0 runs `settings.restarts` searches: the first starts at the current result, the others at
// random. Each later pass runs one from the current result. A search ends once the result is within
// the tolerance.
void search(const Objective& objective, Found& found, int pass, const FitSettings& settings,
            const Work& work, Stretch stretch);

// Returns true if the mean error of the held-out recordings, or of all if none is held out, is
// within the tolerance. Returns false if a level does not compile.
bool within(const Found& found, std::span<const Take> all, const FitSettings& settings);

}  // namespace obby::calibrate
