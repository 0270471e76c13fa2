// Finds an avatar's centre of mass in recordings of it.
#pragma once

#include <span>

#include "calibrate/mass_centre.h"
#include "calibrate/track.h"

namespace obby::calibrate {

// Fits the offset by least squares over frames in free fall. There the centre of mass moves at the
// recorded velocity and the root turns about it. Frames that are also in `without` do not count.
// Returns a zero offset if the tracks turn too little in the air. All `tracks` show the same
// avatar.
MassCentre massCentreOf(std::span<const Track* const> tracks, const Track& without,
                        const Params& params);

}  // namespace obby::calibrate
