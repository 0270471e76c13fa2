// Estimates the age of recorded velocities. A recorder writes a frame's position and velocity,
// which may belong to different instants. Playback from an outdated velocity drifts, and the fit
// compensates with gravity and jumps. An offset of half a physics step does not count as age: a
// semi-implicit step, here as in the engine, moves by the velocity at its end.
#pragma once

#include <span>
#include <vector>

#include "calibrate/objective.h"

namespace obby::calibrate {

// Returns the seconds by which recorded velocities are older than the simulator's at the same
// positions; negative if they are newer. It uses frames of constant acceleration, such as falls.
// Returns 0 where no difference is significant.
double velocityAgeOf(std::span<const Take> takes, schema::PhysicsParams::Reader now);

// Returns the recordings with the velocities that the simulator has at these positions.
std::vector<Take> withVelocitiesOfNow(std::span<const Take> takes,
                                      schema::PhysicsParams::Reader now);

}  // namespace obby::calibrate
