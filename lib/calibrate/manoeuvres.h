// The manoeuvres to record on the calibration course. Each parameter affects at least one of them.
#pragma once

#include <string>
#include <vector>

#include "calibrate/track.h"
#include "level/level.h"

namespace obby::calibrate {

// An input for some seconds: the stick toward (x, z), or released at (0, 0), with or without jump.
struct Hold {
  float seconds, x, z;
  bool jump = false;
};

struct Manoeuvre {
  std::string name;
  Vec3 feet;  // where the player stands at the start
  std::vector<Hold> holds;
};

// Manoeuvres on the course (course_level.h). parameters.cpp lists which parameters each one shows.
std::vector<Manoeuvre> manoeuvres();

// Simulates a manoeuvre with one frame a tick, including the poses of moving and dynamic parts.
// This predicts what a recording can show before it is made. `noise`: max error of a position along
// each axis, studs.
Track rehearse(const level::Level& level, const Manoeuvre& manoeuvre, float noise, uint64_t seed);

// Writes the manoeuvre's start, actions and simulated trajectory, for Studio to play and record.
void writePlan(const level::Level& level, const Manoeuvre& manoeuvre,
               schema::Trajectory::Builder to);

void writeRecording(const Track& track, schema::Recording::Builder to);

}  // namespace obby::calibrate
