// Recorders write a frame's position and velocity of one instant, but an engine need not mean that:
// one that steps by the velocity at a step's end shows one that is half a step older than the path
// (a fall seems 0.4 studs/s slower than it is, at 240 steps a second). A simulator begun with it
// goes astray, and gravity and jumps bend to make up for it.
#pragma once

#include <span>
#include <vector>

#include "calibrate/objective.h"

namespace obby::calibrate {

// Seconds by which velocities are older than the positions that they are written with; negative:
// younger. From frames between which the acceleration stays what it is, such as a fall's. 0 where
// the recordings tell no other.
double velocityAgeOf(std::span<const Take> takes);

// The same recordings with the velocities that the player had at the instants of the positions.
std::vector<Take> withVelocitiesOfNow(std::span<const Take> takes);

}  // namespace obby::calibrate
