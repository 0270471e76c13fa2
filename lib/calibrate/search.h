// The searches of a fit: CMA-ES over all parameters that show, from places of their own.
#pragma once

#include "calibrate/fit_settings.h"
#include "calibrate/found.h"

namespace obby::calibrate {

constexpr double kNoLoss = 1e-6;  // studs^2: less than any recorder shows

// In pass 0 `settings.restarts` of them, which begin anywhere, the first at what is found; in each
// pass after it one that goes on from what is found. They end at the tolerance.
void search(const Objective& objective, Found& found, int pass, const FitSettings& settings,
            const Work& work, Stretch stretch);

// What is found is within the settings' tolerance, of the recordings that are held out, or of all.
// Not where the level of one cannot be played so.
bool within(const Found& found, std::span<const Take> all, const FitSettings& settings);

}  // namespace obby::calibrate
