// What to record: a course, and what a player does there so that each parameter shows in one
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

constexpr const char* kCourseName = "calibration";

// Flat ground, ice of two frictions, a ledge, steps, a ramp, a wall and a truss.
void writeCourse(schema::Level::Builder level);
// On that course.
std::vector<Manoeuvre> manoeuvres();

// What the simulator makes of it, a frame a tick: to see what can be learned of a recording before
// it is made. `noise`: studs that a position may be off, each axis.
Track rehearse(const level::Level& level, const Manoeuvre& manoeuvre, float noise, uint64_t seed);

void writeRecording(const Track& track, schema::Recording::Builder to);

}  // namespace obby::calibrate
