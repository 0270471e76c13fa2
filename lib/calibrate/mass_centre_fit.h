// Finds an avatar's centre of mass in recordings of it.
#pragma once

#include <span>

#include "calibrate/mass_centre.h"
#include "calibrate/track.h"

namespace obby::calibrate {

// By least squares over frames in free fall: there the centre of mass moves by the recorded
// velocity, and the root turns about it. Frames that `without` has too do not count. At the root's
// centre if the tracks turn too little in the air to tell. `tracks`: of one avatar.
MassCentre massCentreOf(std::span<const Track* const> tracks, const Track& without,
                        const Params& params);

}  // namespace obby::calibrate
