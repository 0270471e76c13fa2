// What to record: what a player does on the calibration course, so that each parameter shows in one
// manoeuvre at least.
#pragma once

#include <string>
#include <vector>

#include "calibrate/track.h"
#include "level/level.h"

namespace obby::calibrate {

// The stick toward (x, z), or left alone, and jump or not, for so long.
struct Hold {
  float seconds, x, z;
  bool jump = false;
};

struct Manoeuvre {
  std::string name;
  Vec3 feet;  // where it begins, standing
  std::vector<Hold> holds;
};

// On the course (course_level.h). Each shows some of the parameters: parameters.cpp says which.
std::vector<Manoeuvre> manoeuvres();

// What the simulator makes of it, a frame a tick, with the poses of all that moves or is loose: to
// see what can be learned of a recording before it is made. `noise`: studs that a position may be
// off, each axis.
Track rehearse(const level::Level& level, const Manoeuvre& manoeuvre, float noise, uint64_t seed);

// Its inputs, to be played and recorded in Studio: start, actions, and where they lead in the
// simulator.
void writePlan(const level::Level& level, const Manoeuvre& manoeuvre,
               schema::Trajectory::Builder to);

void writeRecording(const Track& track, schema::Recording::Builder to);

}  // namespace obby::calibrate
