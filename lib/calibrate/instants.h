// How old the velocities of recordings are. A recorder writes a frame's position and velocity, and
// need not mean the same instant by both. A simulator begun with an older velocity goes astray, and
// gravity and jumps bend to make up for it. An age of half a physics step is none: a semi-implicit
// step, the engine's and the simulator's, moves by the velocity at its end.
#pragma once

#include <span>
#include <vector>

#include "calibrate/objective.h"

namespace obby::calibrate {

// Seconds by which velocities are older than a simulator's of `now` at the same positions;
// negative: younger. From frames between which the acceleration stays what it is, such as a fall's.
// 0 where the recordings tell no other.
double velocityAgeOf(std::span<const Take> takes, schema::PhysicsParams::Reader now);

// The same recordings with the velocities that such a simulator has at these positions.
std::vector<Take> withVelocitiesOfNow(std::span<const Take> takes,
                                      schema::PhysicsParams::Reader now);

}  // namespace obby::calibrate
